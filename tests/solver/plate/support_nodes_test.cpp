#include "solver/plate/support_nodes.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;
using doctest::Approx;
using doctest::Contains;

namespace {

const SupportNode* find_node(const SupportNodes& found, Index number, bool on_edge) {
  for (const SupportNode& node : found.nodes)
    if (node.number == number && node.on_edge == on_edge) return &node;
  return nullptr;
}

SupportNodes nodes_of(const Mesh& mesh, std::vector<PlateSupport> supports,
                      PlateElement element = PlateElement::mitc) {
  PlateProblem problem;
  problem.supports = std::move(supports);
  return support_nodes(straight_fe_mesh(mesh), element, problem);
}

/// Angle between a direction and a line.
double off(Vector direction, Vector line) {
  return std::abs(cross(direction, line)) / (norm(direction) * norm(line));
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("each kind holds what the table of conditions says on an oblique edge") {
    const Mesh mesh = turned(square_mesh(2), kSmallAngle);
    const Vector n = turned({0, -1}, kSmallAngle), s = turned({1, 0}, kSmallAngle);
    struct Row {
      SupportKind kind;
      bool w;
      std::vector<Vector> directions;
    };
    for (const Row& row : {Row{SupportKind::clamped, true, {n, s}},
                           {SupportKind::soft_clamped, true, {n}},
                           {SupportKind::hard_support, true, {s}},
                           {SupportKind::soft_support, true, {}},
                           {SupportKind::symmetry, false, {n}},
                           {SupportKind::antisymmetry, true, {s}}}) {
      const SupportNodes found = nodes_of(mesh, {{kBottom, row.kind, {}}});
      CHECK(found.nodes.size() == 5);  // three vertices, two edges
      for (const SupportNode& node : found.nodes) {
        CHECK(node.deflections.size() == (row.w ? 1 : 0));
        REQUIRE(node.directions.size() == row.directions.size());
        for (std::size_t k = 0; k < row.directions.size(); ++k)
          CHECK(off(node.directions[k], row.directions[k]) < 1e-14);
      }
    }
    CHECK(nodes_of(mesh, {{kBottom, SupportKind::free, {}}}).nodes.empty());
  }

  TEST_CASE("the corner of two hard edges takes the union of their conditions") {
    const SupportNodes found = nodes_of(square_mesh(2), {{kBottom, SupportKind::hard_support, {}},
                                                         {kLeft, SupportKind::hard_support, {}}});
    const SupportNode* corner = find_node(found, 0, false);
    REQUIRE(corner);
    CHECK(corner->directions.size() == 2);
    CHECK(corner->deflections.size() == 2);
    REQUIRE(corner->rotations.size() == 2);
    CHECK(corner->rotations[0].tag == kBottom);
    CHECK(off(corner->rotations[0].directions.at(0), {1, 0}) < 1e-15);
    CHECK(corner->rotations[1].tag == kLeft);
    CHECK(off(corner->rotations[1].directions.at(0), {0, 1}) < 1e-15);
    CHECK(find_node(found, 1, false)->directions.size() == 1);
  }

  TEST_CASE("the corner of a hard support and a symmetry axis holds one direction") {
    // theta_s along the bottom and theta_n of the left side are both theta_x.
    const SupportNodes found = nodes_of(square_mesh(2), {{kBottom, SupportKind::hard_support, {}},
                                                         {kLeft, SupportKind::symmetry, {}}});
    const SupportNode* corner = find_node(found, 0, false);
    REQUIRE(corner);
    REQUIRE(corner->directions.size() == 1);
    CHECK(off(corner->directions[0], {1, 0}) < 1e-15);
    CHECK(corner->deflections.size() == 1);
  }

  TEST_CASE("a soft support next to a free edge holds no rotation in the corner") {
    const SupportNodes found = nodes_of(
        square_mesh(2), {{kBottom, SupportKind::soft_support, {}}, {kLeft, SupportKind::free, {}}});
    CHECK(find_node(found, 0, false)->directions.empty());
    CHECK(find_node(found, 3, false) == nullptr);
  }

  TEST_CASE("chords of one curve have the mean normal at their joints") {
    const Mesh mesh = disc_mesh(4);  // turns of 15 degrees
    const SupportNodes found = nodes_of(mesh, {{kRim, SupportKind::hard_support, {}}});
    CHECK(found.smooth_joints == std::vector<Index>{24});
    CHECK(found.nodes.size() == 48);
    for (const SupportNode& node : found.nodes) {
      REQUIRE(node.directions.size() == 1);
      CHECK(std::abs(dot(node.directions[0], node.at)) < 1e-14);
    }
  }

  TEST_CASE("chords of different length on a circle give its tangent") {
    // Vertices of ring 4 moved along the circle by up to 2 degrees.
    Mesh mesh = disc_mesh(4);
    Noise noise(3);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (norm(mesh.points[v]) > 0.9) mesh.points[v] = turned(mesh.points[v], noise() * kPi / 90);
    double worst = 0, chord = 0;
    for (const SupportNode& node : nodes_of(mesh, {{kRim, SupportKind::hard_support, {}}}).nodes) {
      double& error = node.on_edge ? chord : worst;
      error = std::max(error, std::abs(dot(node.directions[0], (1 / norm(node.at)) * node.at)));
    }
    CHECK(chord < 1e-14);
    CHECK(worst < 2e-4);  // the plain mean of the two chords would be off by up to 1 degree / 57
  }

  TEST_CASE("corners of the mesh and turns above thirty degrees are no smooth joints") {
    Mesh mesh = disc_mesh(4);
    for (const CurveEdge& edge : mesh.edges) mesh.corners.push_back(edge.vertices[0]);
    const SupportNodes marked = nodes_of(mesh, {{kRim, SupportKind::hard_support, {}}});
    CHECK(marked.smooth_joints == std::vector<Index>{0});
    for (const SupportNode& node : marked.nodes)
      CHECK(node.directions.size() == (node.on_edge ? 1 : 2));
    const SupportNodes hexagon = nodes_of(disc_mesh(1), {{kRim, SupportKind::hard_support, {}}});
    CHECK(hexagon.smooth_joints == std::vector<Index>{0});
    CHECK(find_node(hexagon, 1, false)->directions.size() == 2);
  }

  TEST_CASE("curved edges have the normals of the curve at all nodes") {
    const CurvedDisc disc(2, 3.);  // turns of 30 degrees
    PlateProblem problem;
    problem.supports = {{kRim, SupportKind::soft_clamped, {}}};
    const SupportNodes found = support_nodes(disc.fe, PlateElement::mitc, problem);
    CHECK(found.smooth_joints == std::vector<Index>{0});
    CHECK(found.nodes.size() == 24);
    for (const SupportNode& node : found.nodes) {
      CHECK(norm(node.at) == Approx(3).epsilon(1e-12));
      REQUIRE(node.directions.size() == 1);
      CHECK(off(node.directions[0], node.at) < 1e-10);
    }
  }

  TEST_CASE("a settlement is taken from its function at the nodes") {
    const SupportNodes found = nodes_of(
        square_mesh(2), {{kBottom, SupportKind::soft_support, [](Point p) { return 2 * p.x; }}});
    for (const SupportNode& node : found.nodes)
      CHECK(node.deflections.at(0).value == Approx(2 * node.at.x));
  }

  TEST_CASE("where edges alone carry the deflection they are held at its mean") {
    // The mean of x^2 over [0, 1/2] is 1/12, not its value 1/16 half way.
    const SupportNodes found = nodes_of(
        square_mesh(2), {{kBottom, SupportKind::soft_support, [](Point p) { return p.x * p.x; }}},
        PlateElement::arnold_falk);
    REQUIRE(found.nodes.size() == 2);
    for (const SupportNode& node : found.nodes)
      CHECK(node.deflections.at(0).value == Approx(node.at.x < 0.5 ? 1. / 12 : 7. / 12));
  }

  TEST_CASE("deflections that contradict each other are refused with the place") {
    Mesh mesh = square_mesh(2);
    mesh.groups = {{1, kBottom, "bottom"}};
    CHECK_THROWS_WITH_AS(
        nodes_of(mesh,
                 {{kBottom, SupportKind::clamped, 0.5}, {kRight, SupportKind::soft_support, {}}}),
        Contains("at (1, 0) the deflection is held at 0.5 by \"bottom\" (tag 1) and at 0 by tag 2"),
        InputError);
    // The same value up to rounding is no contradiction.
    CHECK_NOTHROW(
        nodes_of(mesh, {{kBottom, SupportKind::clamped, [](Point p) { return 0.3 * p.x; }},
                        {kRight, SupportKind::soft_support, 0.1 + 0.2}}));
  }

  TEST_CASE("a settlement that is not a number is refused with the place") {
    CHECK_THROWS_WITH_AS(nodes_of(square_mesh(2), {{kLeft, SupportKind::clamped,
                                                    [](Point p) { return std::log(p.y - 0.1); }}}),
                         Contains("the prescribed deflection is"), InputError);
  }

  TEST_CASE("point supports hold the nearest vertex and add to what curves hold") {
    PlateProblem problem;
    problem.supports = {{kBottom, SupportKind::hard_support, {}}};
    problem.point_supports = {{{0.52, 0.49}, 0.1, true}, {{0.5, 0}, 0, true}};
    const Mesh mesh = square_mesh(2);
    const FeMesh fe = straight_fe_mesh(mesh);
    const SupportNodes found = support_nodes(fe, PlateElement::mitc, problem);
    const SupportNode* centre = find_node(found, 4, false);
    REQUIRE(centre);
    CHECK(centre->deflections.at(0).value == 0.1);
    CHECK(centre->directions.size() == 2);
    CHECK(find_node(found, 1, false)->directions.size() == 2);
    problem.point_supports[1].deflection = 1;
    CHECK_THROWS_WITH_AS(support_nodes(fe, PlateElement::mitc, problem),
                         Contains("and at 1 by a point support"), InputError);
    CHECK_THROWS_AS(support_nodes(fe, PlateElement::arnold_falk, problem), UsageError);
  }

  TEST_CASE("elements of lower order are held where they have unknowns") {
    const std::vector<PlateSupport> clamped{{kBottom, SupportKind::clamped, {}}};
    for (const SupportNode& node : nodes_of(square_quads(2, 2), clamped, PlateElement::mitc4).nodes)
      CHECK_FALSE(node.on_edge);
    const SupportNodes found = nodes_of(square_mesh(2), clamped, PlateElement::arnold_falk);
    CHECK(found.nodes.size() == 5);
    for (const SupportNode& node : found.nodes) {
      CHECK(node.deflections.size() == (node.on_edge ? 1 : 0));
      CHECK(node.directions.size() == (node.on_edge ? 0 : 2));
    }
  }
}
