#include "solver/plate/solve_plate.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;
using doctest::Approx;
using doctest::Contains;

namespace {

/// A strip of the unit square that bends in x only: symmetry along bottom and top.
PlateProblem strip(const PlateMaterial& material, SupportKind left) {
  PlateProblem problem = plate(material);
  problem.supports = {
      {kBottom, SupportKind::symmetry, {}}, {kTop, SupportKind::symmetry, {}}, {kLeft, left, {}}};
  return problem;
}

/// What the rotations and deflections at the nodes of one curve add up to.
struct Held {
  double w = 0, normal = 0, tangential = 0;
};

Held largest_on_curve(const FeMesh& mesh, const PlateSolution& solution, Index tag) {
  Held largest;
  for (std::size_t i = 0; i < mesh.mesh.edges.size(); ++i) {
    if (mesh.mesh.edges[i].tag != tag) continue;
    const Vector t = curve_point(mesh, static_cast<Index>(i), 0.5).tangent;
    const Index first = solution.dofs.at_edge(mesh.edges.curve_edges[i]);
    const Vector theta{solution.values[first + 1], solution.values[first + 2]};
    largest.w = std::max(largest.w, std::abs(solution.values[first]));
    largest.normal = std::max(largest.normal, std::abs(cross(theta, t)));
    largest.tangential = std::max(largest.tangential, std::abs(dot(theta, t)));
  }
  return largest;
}

/// Solves with one kind on the curve and checks what it holds and that it leaves the rest free.
void check_kind(const FeMesh& mesh, Index tag, SupportKind kind, PlateProblem problem) {
  CAPTURE(static_cast<int>(kind));
  problem.supports.push_back({tag, kind, {}});
  const Held held = largest_on_curve(mesh, solve_plate(mesh, problem), tag);
  const bool holds_w = kind != SupportKind::symmetry && kind != SupportKind::free;
  const bool holds_normal = kind == SupportKind::clamped || kind == SupportKind::soft_clamped ||
                            kind == SupportKind::symmetry;
  const bool holds_tangential = kind == SupportKind::clamped || kind == SupportKind::hard_support ||
                                kind == SupportKind::antisymmetry;
  const auto check = [](double value, bool is_held) {
    if (is_held)
      CHECK(value < 1e-15);
    else
      CHECK(value > 1e-6);
  };
  check(held.w, holds_w);
  check(held.normal, holds_normal);
  check(held.tangential, holds_tangential);
}

constexpr std::array kKinds{SupportKind::clamped,      SupportKind::soft_clamped,
                            SupportKind::hard_support, SupportKind::soft_support,
                            SupportKind::free,         SupportKind::symmetry,
                            SupportKind::antisymmetry};

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("every kind holds its part of the unknowns on straight and oblique edges") {
    for (const double angle : {0., kSmallAngle}) {
      const Mesh mesh = turned(mixed_square(4, 4), angle);
      PlateProblem problem = plate(unit_bending(0.1), [](Point p) { return 1 + 3 * p.x + p.y; });
      problem.supports = {{kTop, SupportKind::clamped, {}}};
      for (const SupportKind kind : kKinds)
        check_kind(straight_fe_mesh(mesh), kBottom, kind, problem);
    }
  }

  TEST_CASE("every kind holds its part of the unknowns on a curved edge") {
    const CurvedDisc disc(4);
    PlateProblem problem = plate(unit_bending(0.1), [](Point p) { return 1 + p.x + p.x * p.y; });
    problem.point_supports = {{{0, 0}, 0, true}};
    for (const SupportKind kind : kKinds) check_kind(disc.fe, kRim, kind, problem);
  }

  TEST_CASE("a strip bent by moments at its end has constant moments") {
    // M_xx = m gives w = -m x^2 / (2 D), M_yy = nu m and no shear force.
    const PlateMaterial material{1000, 0.25, 0.1, 5. / 6};  // D = 1 / 11.25
    PlateProblem problem = strip(material, SupportKind::clamped);
    problem.edge_loads = {{kRight, 0, 0.02, 0}};
    const Mesh mesh = perturbed(mixed_square(4, 3), 4, 3, 0.25, 5);
    const FeMesh fe = straight_fe_mesh(mesh);
    const PlateSolution solution = solve_plate(fe, problem);
    for (const PlateState& state : vertex_states(fe, problem, solution)) {
      CHECK(state.w == Approx(-0.1125 * state.x.x * state.x.x).epsilon(1e-10));
      CHECK(state.moments.xx == Approx(0.02).epsilon(1e-9));
      CHECK(state.moments.yy == Approx(0.005).epsilon(1e-9));
      CHECK(std::abs(state.moments.xy) < 1e-11);
      CHECK(norm(state.shear) < 1e-9);
    }
    // Energy m^2 / (2 D), bending only.
    CHECK(solution.energy.bending == Approx(0.00225).epsilon(1e-10));
    CHECK(solution.energy.shear < 1e-12);
    CHECK(solution.work == Approx(0.00225).epsilon(1e-10));
  }

  TEST_CASE("twisting moments on all sides bend a free plate to a saddle") {
    // M_xy = m: M_ns = m on right and left, -m on top and bottom, w = -m x y / (D (1 - nu)).
    PlateProblem problem = plate(unit_bending(0.1));
    problem.edge_loads = {
        {kBottom, 0, 0, -2}, {kRight, 0, 0, 2}, {kTop, 0, 0, -2}, {kLeft, 0, 0, 2}};
    for (const Point p : {Point{0, 0}, Point{1, 0}, Point{0, 1}})
      problem.point_supports.push_back({p, 0, false});
    const Mesh mesh = mixed_square(3, 3);
    const FeMesh fe = straight_fe_mesh(mesh);
    const PlateSolution solution = solve_plate(fe, problem);
    for (const PlateState& state : vertex_states(fe, problem, solution)) {
      CHECK(state.w == Approx(-2 / 0.7 * state.x.x * state.x.y).epsilon(1e-9));
      CHECK(state.moments.xy == Approx(2).epsilon(1e-9));
      CHECK(std::abs(state.moments.xx) + std::abs(state.moments.yy) < 1e-8);
    }
  }

  TEST_CASE("a cantilever strip under a shear force at its end") {
    // w = V (x^2 / 2 - x^3 / 6) / D + V x / S at x = 1: 1/3 + t^2 / 3.5 for D = V = 1.
    PlateProblem problem = strip(unit_bending(0.2), SupportKind::clamped);
    problem.edge_loads = {{kRight, 1, 0, 0}};
    const Mesh mesh = mixed_square(8, 2);
    const FeMesh fe = straight_fe_mesh(mesh);
    const PlateSolution solution = solve_plate(fe, problem);
    const PlateState tip = state_at_vertex(fe, problem, solution, {1, 0.5});
    CHECK(tip.w == Approx(1. / 3 + 0.04 / 3.5).epsilon(1e-5));
    CHECK(tip.shear.x == Approx(1).epsilon(1e-2));
    for (const PlateReaction& r : solution.reactions)
      if (r.tag == kLeft) {
        CHECK(r.force == Approx(-1).epsilon(1e-10));
        CHECK(r.moment.x == Approx(-1).epsilon(1e-10));
      }
  }

  TEST_CASE("two materials side by side bend like a stepped beam") {
    // nu = 0, moment m = 1: w'' = -1 / D1 = -2 left of x = 1/2 and -1 / D2 = -8 right of it.
    Mesh mesh = mixed_square(4, 2);
    const auto region = [](double x) { return x < 0.5 ? 1 : 2; };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      mesh.triangle_regions[t] =
          region((mesh.points[mesh.triangles[t][0]].x + mesh.points[mesh.triangles[t][1]].x +
                  mesh.points[mesh.triangles[t][2]].x) /
                 3);
    for (std::size_t q = 0; q < mesh.quads.size(); ++q)
      mesh.quad_regions[q] =
          region((mesh.points[mesh.quads[q][0]].x + mesh.points[mesh.quads[q][2]].x) / 2);
    PlateProblem problem = strip({6, 0, 1, 5. / 6}, SupportKind::clamped);  // D1 = 6 / 12
    problem.regions = {{2, {12, 0, 0.5, 5. / 6}}};                          // D2 = 12 / 96
    problem.edge_loads = {{kRight, 0, 1, 0}};
    const FeMesh fe = straight_fe_mesh(mesh);
    const PlateSolution solution = solve_plate(fe, problem);
    for (const PlateState& state : vertex_states(fe, problem, solution)) {
      const double x = state.x.x, beyond = std::max(x - 0.5, 0.);
      const double left = std::min(x, 0.5);
      CHECK(state.w == Approx(-left * left - beyond - 4 * beyond * beyond).epsilon(1e-10));
      CHECK(state.moments.xx == Approx(1).epsilon(1e-10));
    }
  }

  TEST_CASE("a settlement turns a hinged plate without stress") {
    PlateProblem problem = plate(unit_bending(0.1));
    problem.supports = {{kLeft, SupportKind::soft_support, {}},
                        {kRight, SupportKind::soft_support, 0.3}};
    const Mesh mesh = turned(mixed_square(3, 3), kSmallAngle);
    const FeMesh fe = straight_fe_mesh(mesh);
    const PlateSolution solution = solve_plate(fe, problem);
    for (const PlateState& state : vertex_states(fe, problem, solution)) {
      CHECK(state.w == Approx(0.3 * turned(state.x, -kSmallAngle).x).epsilon(1e-11));
      CHECK(norm(state.rotation - turned({0.3, 0}, kSmallAngle)) < 1e-11);
    }
    CHECK(solution.energy.total() < 1e-20);
  }

  TEST_CASE("a settlement of a clamped strip costs the force of a beam") {
    // R = delta / (1 / (3 D) + 1 / S), energy R delta / 2.
    PlateProblem problem = strip(unit_bending(0.2), SupportKind::clamped);
    problem.supports.push_back({kRight, SupportKind::soft_support, 0.01});
    const Mesh mesh = mixed_square(8, 2);
    const PlateSolution solution = solve_plate(straight_fe_mesh(mesh), problem);
    const double force = 0.01 / (1. / 3 + 0.04 / 3.5);
    CHECK(solution.reactions.back().force == Approx(force).epsilon(1e-5));
    CHECK(solution.load == 0);
    CHECK(solution.work == Approx(force * 0.01 / 2).epsilon(1e-5));
    CHECK(solution.work == Approx(solution.energy.total()).epsilon(1e-11));
  }

  TEST_CASE("discs with bent rims reach the closed forms of clamped and simply supported circles") {
    const CurvedDisc disc(8);
    PlateProblem problem = plate(unit_bending(0.1), 1.);
    problem.supports = {{kRim, SupportKind::clamped, {}}};
    const PlateSolution clamped = solve_plate(disc.fe, problem);
    const PlateState centre = state_at_vertex(disc.fe, problem, clamped, {0, 0});
    CHECK(centre.w == Approx(0.0163392857142857).epsilon(1e-4));
    CHECK(centre.moments.xx == Approx(0.08125).epsilon(5e-3));
    // U = pi / 384 + pi / (16 S), S = 350
    CHECK(clamped.energy.total() == Approx(kPi / 384 + kPi / 5600).epsilon(1e-4));
    // (5 + nu) / (1 + nu) / 64 + 1 / (4 S): hard and soft supports agree where all is radial.
    for (const SupportKind kind : {SupportKind::hard_support, SupportKind::soft_support}) {
      problem.supports = {{kRim, kind, {}}};
      const PlateSolution simple = solve_plate(disc.fe, problem);
      CHECK(state_at_vertex(disc.fe, problem, simple, {0, 0}).w ==
            Approx(0.06441620879120878).epsilon(1e-4));
    }
  }

  TEST_CASE("hard support of a uniformly loaded square reaches the series solution") {
    PlateProblem problem = plate(unit_bending(0.01), 1.);
    support_all_sides(SupportKind::hard_support, problem);
    const Mesh mesh = mixed_square(12, 12);
    const FeMesh fe = straight_fe_mesh(mesh);
    const PlateSolution solution = solve_plate(fe, problem);
    const PlateState centre = state_at_vertex(fe, problem, solution, {0.5, 0.5});
    CHECK(centre.w == Approx(0.0040644575564830945).epsilon(2e-5));
    CHECK(centre.moments.xx == Approx(0.047886379632983984).epsilon(1e-2));
    CHECK(solution.energy.total() == Approx(8.5175732313e-4).epsilon(1e-4));
    CHECK(solution.linear.residual < 1e-10);
  }

  TEST_CASE("the number of threads does not change a bit") {
    PlateProblem problem = plate(unit_bending(0.01), 1.);
    support_all_sides(SupportKind::soft_support, problem);
    const Mesh mesh = mixed_square(9, 9);
    const FeMesh fe = straight_fe_mesh(mesh);
    PlateOptions one, two;
    one.threads = 1;
    two.threads = 2;
    const PlateSolution a = solve_plate(fe, problem, one), b = solve_plate(fe, problem, two);
    CHECK(a.values == b.values);
    CHECK(a.inner == b.inner);
    CHECK(a.energy.total() == b.energy.total());
  }
}

TEST_SUITE("unit") {
  TEST_CASE("point loads are warned of with the distance to keep") {
    PlateProblem problem = plate(unit_bending(0.01));
    support_all_sides(SupportKind::soft_support, problem);
    problem.point_loads = {{{0.5, 0.5}, 1}};
    const Mesh mesh = square_mesh(4);
    Warnings warnings;
    solve_plate(straight_fe_mesh(mesh), problem, {}, warnings.monitor());
    REQUIRE(warnings.texts.size() == 1);
    CHECK(warnings.texts[0] ==
          "the deflection below the point load at (0.5, 0.5) grows without bound as the mesh gets "
          "finer: read it at least 0.05 (five thicknesses) away, or spread the load over a patch");
  }

  TEST_CASE("hard supports on polygons in place of curves are warned of and soft ones are not") {
    PlateProblem problem = plate(unit_bending(0.1), 1.);
    const Mesh polygon = disc_mesh(4);
    const CurvedDisc disc(4);
    for (const SupportKind kind : {SupportKind::hard_support, SupportKind::clamped}) {
      problem.supports = {{kRim, kind, {}}};
      Warnings on_polygon, on_curve;
      solve_plate(straight_fe_mesh(polygon), problem, {}, on_polygon.monitor());
      solve_plate(disc.fe, problem, {}, on_curve.monitor());
      REQUIRE(on_polygon.texts.size() == 1);
      CHECK(on_polygon.texts[0].find("\"rim\" (tag 7)") != std::string::npos);
      CHECK(on_polygon.texts[0].find("24 smooth joints") != std::string::npos);
      CHECK(on_polygon.texts[0].find("Babuska") != std::string::npos);
      CHECK(on_curve.texts.empty());
    }
    problem.supports = {{kRim, SupportKind::soft_support, {}}};
    Warnings soft;
    solve_plate(straight_fe_mesh(polygon), problem, {}, soft.monitor());
    CHECK(soft.texts.empty());
  }

  TEST_CASE("missing and contradictory supports are refused before anything is solved") {
    const Mesh mesh = square_mesh(2);
    const FeMesh fe = straight_fe_mesh(mesh);
    PlateProblem problem = plate(unit_bending(0.1), 1.);
    CHECK_THROWS_WITH_AS(solve_plate(fe, problem),
                         Contains("can move as a rigid body: no curve supports w"), InputError);
    problem.supports = {{kLeft, SupportKind::clamped, {}}, {kTop, SupportKind::clamped, 1}};
    CHECK_THROWS_WITH_AS(solve_plate(fe, problem), Contains("at (0, 1) the deflection is held at"),
                         InputError);
    problem.supports = {{12, SupportKind::clamped, {}}};
    CHECK_THROWS_WITH_AS(solve_plate(fe, problem), Contains("no edge of the mesh"), InputError);
  }

  TEST_CASE("elements that the shapes of the mesh do not allow are refused") {
    PlateProblem problem = plate(unit_bending(0.1), 1.);
    support_all_sides(SupportKind::clamped, problem);
    const Mesh mesh = mixed_square(2, 2);
    const FeMesh fe = straight_fe_mesh(mesh);
    PlateOptions options;
    options.element = PlateElement::mitc4;
    CHECK_THROWS_WITH_AS(solve_plate(fe, problem, options), Contains("quadrilaterals only"),
                         UsageError);
    options.element = PlateElement::arnold_falk;
    CHECK_THROWS_WITH_AS(solve_plate(fe, problem, options), Contains("triangles only"), UsageError);
  }

  TEST_CASE("a load that is not a number is refused with the place") {
    PlateProblem problem =
        plate(unit_bending(0.1), [](Point p) { return 1 / (p.x < 2 ? 0. : 1.); });
    support_all_sides(SupportKind::clamped, problem);
    const Mesh mesh = square_mesh(2);
    CHECK_THROWS_AS(solve_plate(straight_fe_mesh(mesh), problem), InputError);
  }
}
