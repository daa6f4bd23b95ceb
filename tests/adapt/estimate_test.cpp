#include "adapt/estimate.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "solver/scalar/norms.hpp"
#include "solver/scalar/solve_scalar.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

TEST_SUITE("unit") {
  TEST_CASE("the estimate of a linear solution is zero and its energy is exact") {
    const Mesh mesh = perturbed_mesh(6, 0.3, 8);
    std::vector<double> u;
    for (const Point& p : mesh.points) u.push_back(2 * p.x - p.y);
    const auto estimate = estimate_energy_error(mesh, {3, 6, {}, {}}, u, fit_quadratics(mesh, u));
    CHECK(estimate.error < 1e-12);
    // int 3 * 5 + 6 (2x - y)^2 = 15 + 6 * (4/3 - 1 + 1/3).
    CHECK(estimate.energy * estimate.energy == doctest::Approx(19));
  }

  TEST_CASE("the estimate of a quadratic is the interpolation error") {
    // u = x^2 on n columns: grad e = 2x - (x_i + x_{i+1}), its square integrates to 1 / (3 n^2).
    const Mesh mesh = square_mesh(8, 3);
    std::vector<double> u;
    for (const Point& p : mesh.points) u.push_back(p.x * p.x);
    const auto estimate = estimate_energy_error(mesh, {1, 0, {}, {}}, u, fit_quadratics(mesh, u));
    CHECK(estimate.error * estimate.error == doctest::Approx(1. / (3 * 64)));
  }
}

TEST_SUITE("convergence") {
  TEST_CASE("the effectivity of the estimate tends to one on a smooth problem") {
    const ExactSolution exact = sine_product(1, 1);
    ScalarProblem problem{1, 1, exact.source, {}};
    for (const Index side : {kBottom, kRight, kTop, kLeft})
      problem.dirichlet.push_back({side, [](Point) { return 0.; }});
    for (const Index n : {16, 48}) {
      const Mesh mesh = perturbed_mesh(n, 0.25, 9);
      const FeMesh fe = straight_fe_mesh(mesh);
      const ScalarField field = solve_scalar(fe, problem).field;
      const std::vector<double>& u = field.values;
      const double estimate =
          estimate_energy_error(mesh, problem, u, fit_quadratics(mesh, u)).error;
      const double effectivity = estimate / error_norms(fe, problem, exact, field).energy;
      CAPTURE(n);
      CHECK(effectivity == doctest::Approx(1).epsilon(n == 16 ? 0.1 : 0.05));
    }
  }
}
