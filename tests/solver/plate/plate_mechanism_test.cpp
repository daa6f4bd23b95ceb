#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "solver/plate/plate_supports.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;
using doctest::Contains;

namespace {

void require(const Mesh& mesh, const PlateProblem& problem,
             PlateElement element = PlateElement::mitc) {
  const FeMesh fe = straight_fe_mesh(mesh);
  const DofMap dofs = make_dof_map(fe, plate_layout(element));
  require_supported(fe, dofs, element, plate_conditions(fe, dofs, element, problem));
}

void check_free(const Mesh& mesh, const PlateProblem& problem, const char* words) {
  CHECK_THROWS_WITH_AS(require(mesh, problem), Contains(words), InputError);
}

PlateProblem supported(std::vector<PlateSupport> supports) {
  PlateProblem problem;
  problem.supports = std::move(supports);
  return problem;
}

PlateProblem pinned(const std::vector<Point>& points) {
  PlateProblem problem;
  for (const Point p : points) problem.point_supports.push_back({p, 0, false});
  return problem;
}

/// A second square beside square_mesh(2), in region 2, that shares no vertex with it; its sides
/// have tags 11 to 14.
Mesh two_squares(Vector offset) {
  Mesh mesh = square_mesh(2);
  const Mesh second = square_mesh(2);
  const auto first = static_cast<Index>(mesh.points.size());
  for (const Point p : second.points) mesh.points.push_back(p + offset);
  for (const auto& [a, b, c] : second.triangles)
    mesh.triangles.push_back({a + first, b + first, c + first});
  mesh.triangle_regions.resize(mesh.triangles.size(), 2);
  for (CurveEdge edge : second.edges) {
    edge.vertices = {edge.vertices[0] + first, edge.vertices[1] + first};
    edge.tag += 10;
    mesh.edges.push_back(edge);
  }
  mesh.groups = {{2, 1, "slab"}, {2, 2, "annex"}};
  return mesh;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a plate without supports can move as a rigid body") {
    check_free(square_mesh(2), {}, "can move as a rigid body: no curve supports w");
    check_free(square_mesh(2), supported({{kLeft, SupportKind::free, {}}}), "no curve supports w");
  }

  TEST_CASE("symmetry axes alone leave the deflection free") {
    check_free(
        square_mesh(2),
        supported({{kLeft, SupportKind::symmetry, {}}, {kBottom, SupportKind::symmetry, {}}}),
        "can move as a rigid body: no curve supports w");
  }

  TEST_CASE("one simply supported side leaves the turn about it free") {
    for (const SupportKind kind : {SupportKind::soft_support, SupportKind::hard_support})
      check_free(square_mesh(2), supported({{kRight, kind, {}}}),
                 "in region tag 1 round (0.5, 0.5) can turn about the line through (1, 0.5) in "
                 "direction (0, 1)");
    // The bottom side turned by 45 degrees.
    check_free(turned(square_mesh(2), kPi / 4),
               supported({{kBottom, SupportKind::soft_support, {}}}),
               "through (0.3535534, 0.3535534) in direction (0.707107, 0.707107)");
  }

  TEST_CASE("two pins leave the turn about their line free") {
    check_free(square_mesh(2), pinned({{0, 0}, {1, 1}}),
               "can turn about the line through (0.5, 0.5)");
  }

  TEST_CASE("one pin leaves the turns about it free") {
    check_free(square_mesh(2), pinned({{1, 0}}),
               "can turn about the point (1, 0) in every direction");
  }

  TEST_CASE("three pins on a line do not hold a plate but three others do") {
    check_free(square_mesh(2), pinned({{0, 0}, {0.5, 0}, {1, 0}}),
               "can turn about the line through (0.5, 0) in direction (1, 0)");
    CHECK_NOTHROW(require(square_mesh(2), pinned({{0, 0}, {1, 0}, {0, 1}})));
  }

  TEST_CASE("a turn is held by a rotation as well as by a deflection") {
    // The hinge at the left side turns about y, which the symmetry of the bottom side allows and
    // that of the right side does not.
    const PlateSupport hinge{kLeft, SupportKind::soft_support, {}};
    check_free(square_mesh(2), supported({hinge, {kBottom, SupportKind::symmetry, {}}}),
               "can turn about the line through (0, 0.5) in direction (0, 1)");
    CHECK_NOTHROW(require(square_mesh(2), supported({hinge, {kRight, SupportKind::symmetry, {}}})));
    CHECK_NOTHROW(require(square_mesh(2), supported({{kLeft, SupportKind::soft_clamped, {}}})));
  }

  TEST_CASE("a curved simple support and one clamped vertex hold a plate") {
    CHECK_NOTHROW(require(disc_mesh(3), supported({{kRim, SupportKind::soft_support, {}}})));
    PlateProblem problem;
    problem.point_supports = {{{0, 0}, 0, true}};
    CHECK_NOTHROW(require(disc_mesh(3), problem));
  }

  TEST_CASE("every part is checked on its own and named by its region") {
    const Mesh mesh = two_squares({3, 0});
    const PlateProblem first = supported({{kLeft, SupportKind::clamped, {}}});
    check_free(mesh, first,
               "the plate in region \"annex\" (tag 2) round (3.5, 0.5) can move as a rigid");
    const PlateProblem second = supported({{14, SupportKind::clamped, {}}});
    check_free(mesh, second, "\"slab\" (tag 1) round (0.5, 0.5)");
    CHECK_NOTHROW(require(
        mesh, supported({{kLeft, SupportKind::clamped, {}}, {14, SupportKind::clamped, {}}})));
  }

  TEST_CASE("squares that share a vertex are one plate where w lives on vertices") {
    Mesh mesh = two_squares({1, 1});  // vertex 8 of the first lies on vertex 0 of the second
    for (Triangle& t : mesh.triangles)
      for (Index& v : t)
        if (v == 9) v = 8;
    for (CurveEdge& edge : mesh.edges)
      for (Index& v : edge.vertices)
        if (v == 9) v = 8;
    const PlateProblem problem = supported({{kLeft, SupportKind::clamped, {}}});
    CHECK_NOTHROW(require(mesh, problem));
    CHECK_THROWS_WITH_AS(require(mesh, problem, PlateElement::arnold_falk), Contains("annex"),
                         InputError);
  }

  TEST_CASE("the size and the place of a plate do not matter") {
    for (const double scale : {1e-6, 1., 1e6}) {
      const Mesh mesh = mapped(square_mesh(2), [scale](Point p) {
        return Point{scale * (p.x + 1000), scale * (p.y - 2000)};
      });
      CHECK_NOTHROW(require(mesh, supported({{kLeft, SupportKind::clamped, {}}})));
      check_free(mesh, supported({{kLeft, SupportKind::soft_support, {}}}), "in direction (0, 1)");
    }
  }

  TEST_CASE("low order elements are held by the same supports") {
    const PlateProblem hinge = supported({{kLeft, SupportKind::hard_support, {}}});
    CHECK_THROWS_WITH_AS(require(square_quads(2, 2), hinge, PlateElement::mitc4),
                         Contains("can turn about the line through (0, 0.5)"), InputError);
    CHECK_THROWS_WITH_AS(require(square_mesh(2), hinge, PlateElement::arnold_falk),
                         Contains("can turn about the line through (0, 0.5)"), InputError);
    const PlateProblem clamped = supported({{kLeft, SupportKind::clamped, {}}});
    CHECK_NOTHROW(require(square_quads(2, 2), clamped, PlateElement::mitc4));
    CHECK_NOTHROW(require(square_mesh(2), clamped, PlateElement::arnold_falk));
  }
}
