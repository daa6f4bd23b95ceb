#include "adapt/reference.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "solver/scalar/norms.hpp"
#include "tests/adapt/flux_data.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

double difference(const FeMesh& fine_mesh, const ScalarField& fine, const FeMesh& coarse_mesh,
                  const ScalarField& coarse, const ScalarProblem& problem) {
  return energy_of_difference(
      scalar_flux(fine_mesh, problem, fine), coarse_mesh, [&](const Location& place) {
        return scalar_flux_at(coarse_mesh, problem, coarse, place.element, place.at);
      });
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the energy of the difference of two planes is exact on any two meshes") {
    const Mesh fine = perturbed_mesh(7, 0.2, 3), coarse = square_quads(3, 2);
    const FeMesh fine_fe = straight_fe_mesh(fine), coarse_fe = straight_fe_mesh(coarse);
    ScalarProblem problem;
    problem.diffusion = 4.;
    const auto u = interpolant(fine_fe, 1, [](Point p) { return 5 * p.x - p.y; });
    const auto v = interpolant(coarse_fe, 1, [](Point p) { return 2 * p.x + 3 * p.y; });
    // sqrt(4 (3^2 + 4^2))
    CHECK(difference(fine_fe, u, coarse_fe, v, problem) == doctest::Approx(10));
    CHECK(difference(fine_fe, u, fine_fe, u, problem) < 1e-12);
    CHECK(energy_of(scalar_flux(fine_fe, problem, u)) == doctest::Approx(2 * std::sqrt(26.)));
  }

  TEST_CASE("the value at equal error lies on the log-log polyline") {
    // y = 1 / x, then y = 8 / x^2.
    const std::vector<double> x{1, 4, 8, 32}, y{1, 0.25, 0.125, 0.0078125};
    CHECK(*at_equal_error(x, y, 0.5) == doctest::Approx(2));
    CHECK(*at_equal_error(x, y, 0.25) == doctest::Approx(4));
    CHECK(*at_equal_error(x, y, 8. / 256) == doctest::Approx(16));
    CHECK(*at_equal_error(x, y, 1) == doctest::Approx(1));
    CHECK(*at_equal_error(x, y, 0.0078125) == doctest::Approx(32));
  }

  TEST_CASE("outside the range of the points there is no value at equal error") {
    const std::vector<double> x{10, 20}, y{0.4, 0.2};
    CHECK_FALSE(at_equal_error(x, y, 0.5));
    CHECK_FALSE(at_equal_error(x, y, 0.1));
    CHECK_FALSE(at_equal_error({}, {}, 0.1));
    CHECK(*at_equal_error(std::vector{7.}, std::vector{0.3}, 0.3) == 7);
    CHECK_FALSE(at_equal_error(std::vector{7.}, std::vector{0.3}, 0.2));
  }

  TEST_CASE("of several crossings the last counts") {
    const std::vector<double> x{1, 2, 4, 8}, y{1, 0.25, 1, 0.25};
    CHECK(*at_equal_error(x, y, 0.5) == doctest::Approx(4 * std::sqrt(2.)));
  }
}

TEST_SUITE("convergence") {
  TEST_CASE("a solution of second order stands in for the exact one") {
    const ExactSolution exact = sine_product(1, 0);
    const ScalarProblem problem = dirichlet_problem(exact, 1, 0);
    const Mesh coarse = perturbed_mesh(8, 0.2, 4), fine = square_mesh(16);
    const FeMesh coarse_fe = straight_fe_mesh(coarse), fine_fe = straight_fe_mesh(fine);
    ScalarOptions second;
    second.order = 2;
    const auto u = solve_scalar(coarse_fe, problem).field;
    const auto better = solve_scalar(fine_fe, problem, second).field;
    CHECK(difference(fine_fe, better, coarse_fe, u, problem) ==
          doctest::Approx(error_norms(coarse_fe, problem, exact, u).energy).epsilon(0.02));
  }
}
