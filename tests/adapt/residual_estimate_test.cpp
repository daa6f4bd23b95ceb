#include <cmath>

#include <doctest/doctest.h>

#include "tests/adapt/flux_data.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

double residual_of(const Mesh& mesh, const ScalarProblem& problem, int order,
                   const ScalarFunction& u) {
  const FeMesh fe = straight_fe_mesh(mesh);
  return estimate_by_residual(fe, problem, interpolant(fe, order, u)).error;
}

struct Bound {
  double estimate = 0, error = 0;
  double factor() const { return estimate / error; }
};

Bound bound_on(const Mesh& mesh, int order, const ExactSolution& exact, double diffusion,
               double reaction) {
  const SolvedProblem solved = solved_problem(mesh, order, exact, diffusion, reaction);
  return {estimate_by_residual(solved.mesh, solved.problem, solved.field).error, solved.true_error};
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a linear solution with all its conditions has no residual") {
    // u = 2x - y, -div((1 + x) grad u) + (1, 3) . grad u + 5 u = -2 - 1 + 5 u.
    const auto u = [](Point p) { return 2 * p.x - p.y; };
    ScalarProblem problem;
    problem.diffusion = [](Point p) { return 1 + p.x; };
    problem.reaction = 5.;
    problem.velocity_x = 1.;
    problem.velocity_y = 3.;
    problem.source = [&](Point p) { return -3 + 5 * u(p); };
    problem.dirichlet = {{kBottom, u}};
    problem.fluxes = {{kRight, 4., 0.},                                      // (1 + x) 2
                      {kTop, [](Point p) { return -(1 + p.x); }, 0.},        // -(1 + x)
                      {kLeft, [&](Point p) { return -2 + 7 * u(p); }, 7.}};  // Robin
    for (const Mesh& mesh : {perturbed_mesh(4, 0.2, 1), mixed_square(4, 3), square_quads(3, 3)})
      CHECK(residual_of(mesh, problem, 1, u) < 1e-7);
    CHECK(residual_of(square_quads(3, 3), problem, 2, u) < 1e-7);
    problem.fluxes[0].flux = 4.5;
    CHECK(residual_of(square_mesh(4), problem, 1, u) > 0.01);
  }

  TEST_CASE("a quadratic solution has no residual with second-order elements") {
    const auto u = [](Point p) { return p.x * p.x + 3 * p.x * p.y - 2 * p.y * p.y; };
    ScalarProblem problem;
    problem.diffusion = 2.;
    problem.source = 4.;  // -2 (2 - 4)
    for (const Index side : {kBottom, kRight, kTop, kLeft}) problem.dirichlet.push_back({side, u});
    CHECK(residual_of(perturbed_mesh(4, 0.2, 1), problem, 2, u) < 1e-10);
    CHECK(residual_of(mixed_square(4, 4), problem, 2, u) < 1e-10);
    CHECK(residual_of(square_mesh(4), problem, 1, u) > 0.1);
  }

  TEST_CASE("a line source is a jump that belongs to the solution") {
    // u = -|x - 1/2|: the fluxes out of both sides sum to 2 a.
    const auto u = [](Point p) { return -std::abs(p.x - 0.5); };
    const Mesh mesh = with_middle_curve(square_mesh(4), 1);
    ScalarProblem problem;
    problem.diffusion = 3.;
    for (const Index side : {kRight, kLeft}) problem.dirichlet.push_back({side, u});
    CHECK(residual_of(mesh, problem, 1, u) > 0.5);
    problem.fluxes.push_back({kMiddle, -6., 0.});
    CHECK(residual_of(mesh, problem, 1, u) > 0.5);
    problem.fluxes.back().flux = 6.;
    CHECK(residual_of(mesh, problem, 1, u) < 1e-12);
    // So is the jump over a line where u is prescribed.
    problem.fluxes.clear();
    problem.dirichlet.push_back({kMiddle, 0.});
    CHECK(residual_of(mesh, problem, 1, u) < 1e-12);
  }

  TEST_CASE("the residual of a constant load on a zero field is the smallest height") {
    // alpha_T = height / sqrt(a) = 1 / (10 * 2) on cells of 1/10 x 1/2, no jumps.
    const Mesh mesh = square_quads(10, 2);
    ScalarProblem problem;
    problem.diffusion = 4.;
    problem.source = 3.;
    const auto zero = [](Point) { return 0.; };
    CHECK(residual_of(mesh, problem, 1, zero) == doctest::Approx(3 * 0.05));
    // Triangles of the same cells: height 2 |T| / longest edge = 0.05 / sqrt(0.26).
    CHECK(residual_of(square_mesh(10, 2), problem, 1, zero) ==
          doctest::Approx(3 * 0.5 * 0.05 / std::sqrt(0.26)));
    // Strong reaction takes over: alpha_T = 1 / sqrt(c).
    problem.reaction = 1e4;
    CHECK(residual_of(mesh, problem, 1, zero) == doctest::Approx(3 * 0.01));
  }
}

TEST_SUITE("convergence") {
  TEST_CASE("the residual bounds the error from above and falls with its order") {
    for (const int order : {1, 2}) {
      CAPTURE(order);
      const auto mesh = [](Index n) { return perturbed(mixed_square(n, n), n, n, 0.2, 3); };
      const Bound coarse = bound_on(mesh(10), order, sine_product(1, 1), 1, 1);
      const Bound fine = bound_on(mesh(20), order, sine_product(1, 1), 1, 1);
      CHECK(fine.factor() > 1.5);
      CHECK(fine.factor() < 8);
      CHECK(std::log2(coarse.estimate / fine.estimate) == doctest::Approx(order).epsilon(0.1));
    }
  }

  TEST_CASE("the bound does not depend on stretch or on the width of the layer") {
    for (const int order : {1, 2})
      for (const double eps : {1e-1, 1e-2, 1e-3}) {
        CAPTURE(order);
        CAPTURE(eps);
        const Mesh mesh = eps < 0.05 ? shishkin(square_mesh(24), 24, eps) : square_mesh(24);
        const Bound bound = bound_on(mesh, order, product_layer(eps * eps, 1), eps * eps, 1);
        CHECK(bound.factor() > 2);
        CHECK(bound.factor() < 8);
      }
  }
}
