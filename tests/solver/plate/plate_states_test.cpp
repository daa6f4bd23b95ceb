#include <cmath>

#include <doctest/doctest.h>

#include "solver/plate/solve_plate.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;
using doctest::Approx;

namespace {

/// A mixed plate with a solution that is not polynomial.
struct Solved {
  Mesh mesh = perturbed(mixed_square(4, 4), 4, 4, 0.2, 11);
  FeMesh fe = straight_fe_mesh(mesh);
  PlateProblem problem = plate(unit_bending(0.1), 1.);
  PlateSolution solution;
  Solved() {
    support_all_sides(SupportKind::soft_support, problem);
    solution = solve_plate(fe, problem);
  }
};

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("deflections and rotations at vertices are the unknowns there") {
    const Solved s;
    const auto states = vertex_states(s.fe, s.problem, s.solution);
    REQUIRE(states.size() == s.mesh.points.size());
    for (std::size_t v = 0; v < states.size(); ++v) {
      CHECK(states[v].x == s.mesh.points[v]);
      CHECK(std::abs(states[v].w - s.solution.values[3 * v]) < 1e-16);
      CHECK(std::abs(states[v].rotation.x - s.solution.values[3 * v + 1]) < 1e-15);
      CHECK(std::abs(states[v].rotation.y - s.solution.values[3 * v + 2]) < 1e-15);
    }
  }

  TEST_CASE(
      "moments and shear forces at a vertex are the mean of those in the elements around it") {
    const Solved s;
    // Vertex 0 belongs to both triangles of the first cell, vertex 1 to the second of none.
    const auto at = [&](Index element, ReferencePoint p) {
      return plate_state(s.fe, s.problem, s.solution, element_at(s.fe, element), p);
    };
    const PlateState a = at(0, {0, 0}), b = at(1, {0, 0});
    REQUIRE(element_at(s.fe, 0).vertices[0] == 0);
    REQUIRE(element_at(s.fe, 1).vertices[0] == 0);
    const PlateState corner = vertex_states(s.fe, s.problem, s.solution)[0];
    CHECK(corner.moments.xx == Approx((a.moments.xx + b.moments.xx) / 2));
    CHECK(corner.moments.yy == Approx((a.moments.yy + b.moments.yy) / 2));
    CHECK(corner.moments.xy == Approx((a.moments.xy + b.moments.xy) / 2));
    CHECK(corner.shear.x == Approx((a.shear.x + b.shear.x) / 2));
    CHECK(corner.shear.y == Approx((a.shear.y + b.shear.y) / 2));
    CHECK(a.moments.xx != b.moments.xx);
  }
}
