#include "solver/scalar/boundary_flux.hpp"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/disc_mesh.hpp"
#include "tests/solver/scalar/scalar_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

double flux_of(const Mesh& mesh, const ScalarProblem& problem, int order, Index tag) {
  const FeMesh fe = straight_fe_mesh(mesh);
  return total_flux(fe, problem, solve_scalar(fe, problem, of_order(order)).field, tag, 1);
}

Mesh rough(Index n) { return perturbed(mixed_square(n, n), n, n, 0.25, 8); }

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the fluxes of linear and quadratic solutions are exact") {
    // 3 grad(x^2 - y^2 + x) over right, top, left, bottom: 3 * (3, -2, -1, 0); order 1: 3 * (1, 0,
    // -1, 0) for u = x.
    const auto quadratic =
        with_values(3, 0, 0, [](Point p) { return p.x * p.x - p.y * p.y + p.x; });
    const auto linear = with_values(3, 0, 0, [](Point p) { return p.x; });
    const struct {
      Index tag;
      double of_linear, of_quadratic;
    } sides[] = {{kRight, 3, 9}, {kTop, 0, -6}, {kLeft, -3, -3}, {kBottom, 0, 0}};
    for (const auto& [tag, of_linear, of_quadratic] : sides) {
      CAPTURE(tag);
      CHECK(std::abs(flux_of(rough(5), linear, 1, tag) - of_linear) < 1e-11);
      CHECK(std::abs(flux_of(rough(5), quadratic, 2, tag) - of_quadratic) < 1e-10);
    }
  }

  TEST_CASE("the fluxes balance the sources whatever the mesh") {
    // Left prescribed, right Robin, top Neumann: reactions + fluxes + int f - int c u = 0, c = 0.
    ScalarProblem problem;
    problem.source = [](Point p) { return std::exp(p.x) * p.y; };
    problem.dirichlet = {{kLeft, 2}};
    problem.fluxes = {{kRight, 1, 3}, {kTop, -0.5, {}}};
    const double source = 0.5 * (std::exp(1) - 1);
    for (const int order : {1, 2}) {
      double sum = source;
      for (const Index tag : {kBottom, kRight, kTop, kLeft})
        sum += flux_of(rough(4), problem, order, tag);
      CHECK(std::abs(sum) < 1e-6);  // quadrature of the source
      CHECK(flux_of(rough(4), problem, order, kTop) == doctest::Approx(-0.5));
      CHECK(flux_of(rough(4), problem, order, kBottom) == 0);
    }
  }

  TEST_CASE("a quarter of a uniform load leaves through each side of the square") {
    for (const int order : {1, 2})
      for (const Index tag : {kBottom, kRight, kTop, kLeft})
        CHECK(flux_of(square_quads(6, 6), with_values(1, 0, 1, 0), order, tag) ==
              doctest::Approx(-0.25));
  }

  TEST_CASE("the flux over a bent boundary is the load of the disc") {
    const Mesh mesh = disc_mesh(4);
    const FeMesh fe = curved_fe_mesh(mesh, disc_domain());
    const ScalarProblem problem{1., 0., 1., {{kRim, 0}}};
    const auto u = solve_scalar(fe, problem, of_order(2)).field;
    CHECK(total_flux(fe, problem, u, kRim) == doctest::Approx(-std::numbers::pi).epsilon(1e-4));
  }

  TEST_CASE("the flux over a tag that no edge carries is refused") {
    CHECK_THROWS_WITH_AS(flux_of(square_mesh(2), with_values(1, 0, 1, 0), 1, 99),
                         doctest::Contains("tag 99"), InputError);
  }
}

TEST_SUITE("convergence") {
  TEST_CASE("reactions converge twice as fast as the gradients") {
    // sin(pi x) sin(pi y): int -du/dy over the bottom is -2.
    const ExactSolution exact = sine_product(1, 0);
    const auto problem = problem_of(exact, 1, 0);
    for (const int order : {1, 2}) {
      const double coarse = flux_of(square_mesh(8), problem, order, kBottom) + 2;
      const double fine = flux_of(square_mesh(16), problem, order, kBottom) + 2;
      CAPTURE(order);
      CHECK(std::log2(std::abs(coarse / fine)) > 2 * order - 0.3);
    }
  }

  TEST_CASE("fluxes that jump at a corner are told apart") {
    // Harmonic cubic x^3 - 3 x y^2: du/dn over the right side int 3 - 3 y^2 = 2, top int -6 x = -3.
    const auto problem =
        with_values(1, 0, 0, [](Point p) { return p.x * p.x * p.x - 3 * p.x * p.y * p.y; });
    for (const int order : {1, 2}) {
      const double coarse = std::abs(flux_of(rough(8), problem, order, kRight) - 2);
      const double fine = std::abs(flux_of(rough(32), problem, order, kRight) - 2);
      CHECK(std::log2(coarse / fine) / 2 > order + 0.7);
      CHECK(flux_of(rough(16), problem, order, kTop) ==
            doctest::Approx(-3).epsilon(order == 1 ? 5e-3 : 2e-5));
    }
  }
}
