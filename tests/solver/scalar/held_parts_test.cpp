#include "solver/scalar/held_parts.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

bool is_held(const Mesh& mesh, const ScalarProblem& problem,
             const std::vector<Constraint>& constraints = {}) {
  try {
    require_held_parts(straight_fe_mesh(mesh), problem, constraints);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a value or a reaction or a transfer holds a part and a source or a flux does not") {
    const Mesh mesh = mixed_square(3, 3);
    ScalarProblem problem;
    problem.source = 1;
    problem.fluxes = {{kLeft, 2, {}}};
    CHECK_FALSE(is_held(mesh, problem));
    CHECK(is_held(mesh, problem, {{5, 1}}));
    problem.fluxes[0].transfer = [](Point p) { return p.y > 0.9 ? 1. : 0.; };
    CHECK(is_held(mesh, problem));
    problem.fluxes[0].transfer = [](Point) { return 0.; };
    CHECK_FALSE(is_held(mesh, problem));
    problem.reaction = [](Point p) { return p.x < 0.1 ? 1. : 0.; };
    CHECK(is_held(mesh, problem));
    problem.reaction = [](Point p) { return p.x > 2 ? 1. : 0.; };
    CHECK_FALSE(is_held(mesh, problem));
  }

  TEST_CASE("parts that touch in a vertex hold each other") {
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {5, 5}, {6, 5}, {5, 6}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
    CHECK(is_held(mesh, {}, {{2, 0}}));
    mesh.triangles.push_back({5, 6, 7});
    CHECK_FALSE(is_held(mesh, {}, {{2, 0}}));
    CHECK(is_held(mesh, {}, {{2, 0}, {7, 0}}));
  }
}
