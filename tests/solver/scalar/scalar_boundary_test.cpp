#include "solver/scalar/scalar_boundary.hpp"

#include <numbers>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "solver/scalar/scalar_basis.hpp"
#include "solver/scalar/scalar_system.hpp"
#include "tests/solver/disc_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

TEST_SUITE("unit") {
  TEST_CASE("values are prescribed at the vertices and edge points of the curve") {
    const Mesh mesh = disc_mesh(2);
    const FeMesh fe = curved_fe_mesh(mesh, disc_domain());
    const ScalarProblem problem{1., 0., 0., {{kRim, [](Point p) { return 10 + p.x; }}}};
    const DofMap dofs = make_dof_map(fe, scalar_layout(2));
    const auto constraints = scalar_constraints(fe, problem, dofs);
    REQUIRE(constraints.size() == 24);
    for (const auto& [unknown, value] : constraints) {
      const Point p =
          unknown < dofs.vertices ? mesh.points[unknown] : fe.edge_points[unknown - dofs.vertices];
      CHECK(value == doctest::Approx(10 + p.x));
      CHECK(norm(p) == doctest::Approx(1));
    }
    CHECK(scalar_constraints(fe, problem, make_dof_map(fe, scalar_layout(1))).size() == 12);
  }

  TEST_CASE("fluxes over bent edges add the length of the curve") {
    // int 3 over the circle, and transfer 5 times int u over it for u = 1.
    const Mesh mesh = disc_mesh(4);
    const FeMesh fe = curved_fe_mesh(mesh, disc_domain());
    ScalarProblem problem;
    problem.fluxes = {{kRim, 3, 5}};
    const DofMap dofs = make_dof_map(fe, scalar_layout(2));
    const LinearSystem system = scalar_system(fe, problem, dofs, 2, 1);
    CHECK(system.rhs.sum() == doctest::Approx(6 * std::numbers::pi).epsilon(1e-5));
    CHECK(system.matrix.sum() == doctest::Approx(10 * std::numbers::pi).epsilon(1e-5));
  }

  TEST_CASE("conditions are looked up by tag") {
    const std::vector<DirichletCondition> conditions{{4, 0}, {2, 1}};
    CHECK(condition_on(conditions, 2) == 1);
    CHECK(condition_on(conditions, 3) == -1);
  }
}
