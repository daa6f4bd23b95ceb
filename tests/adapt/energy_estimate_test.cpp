#include "adapt/energy_estimate.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/adapt/flux_data.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// Estimated over true energy error.
double effectivity(const Mesh& mesh, int order, const ExactSolution& exact, double diffusion,
                   double reaction) {
  const SolvedProblem solved = solved_problem(mesh, order, exact, diffusion, reaction);
  return estimate_by_recovery(solved.mesh, solved.problem, solved.field).error / solved.true_error;
}

double on_sine(const Mesh& mesh, int order) {
  return effectivity(mesh, order, sine_product(1, 1), 1, 1);
}

double on_layer(const Mesh& mesh, Index n, int order) {
  constexpr double kEps = 0.01;
  return effectivity(shishkin(mesh, n, kEps), order, product_layer(kEps * kEps, 1), kEps * kEps, 1);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the estimate of a solution in the space is zero and its energy exact") {
    const Mesh mesh = perturbed(mixed_square(5, 4), 5, 4, 0.2, 8);
    const FeMesh fe = straight_fe_mesh(mesh);
    ScalarProblem problem;
    problem.diffusion = 3.;
    problem.reaction = 6.;
    const auto plane = [](Point p) { return 2 * p.x - p.y; };
    for (const int order : {1, 2}) {
      const auto estimate = estimate_by_recovery(fe, problem, interpolant(fe, order, plane));
      CHECK(estimate.error < 1e-12);
      // int 3 * 5 + 6 (2x - y)^2 = 15 + 6 * (4/3 - 1 + 1/3).
      CHECK(estimate.energy * estimate.energy == doctest::Approx(19));
    }
    const Mesh triangles = perturbed_mesh(5, 0.3, 8);
    const FeMesh p2 = straight_fe_mesh(triangles);
    const auto paraboloid = [](Point p) { return p.x * p.x - 3 * p.x * p.y; };
    CHECK(estimate_by_recovery(p2, problem, interpolant(p2, 2, paraboloid)).error < 1e-12);
  }

  TEST_CASE("the estimate of an interpolated quadratic is its error") {
    // u = x^2 on n columns: grad e = 2x - (x_i + x_{i+1}), its square integrates to 1 / (3 n^2).
    for (const Mesh& mesh : {square_mesh(8, 3), square_quads(8, 3)}) {
      const FeMesh fe = straight_fe_mesh(mesh);
      ScalarProblem problem;
      problem.diffusion = 4.;
      const auto u = interpolant(fe, 1, [](Point p) { return p.x * p.x; });
      const auto estimate = estimate_by_recovery(fe, problem, u);
      CHECK(estimate.error * estimate.error == doctest::Approx(4. / (3 * 64)));
      CHECK(estimate.energy * estimate.energy == doctest::Approx(16. / 3));
      CHECK(estimate.relative() == doctest::Approx(estimate.error / estimate.energy));
    }
  }

  TEST_CASE("on Q2 the estimate of an interpolated cubic is its error") {
    // u = x^3 with element width h = 1/6: e = x (x^2 - h^2 / 4) from the centre of an element, its
    // slope squared integrates to h^5 / 20 per element and unit height.
    const Mesh mesh = square_quads(6, 4);
    const FeMesh fe = straight_fe_mesh(mesh);
    const auto u = interpolant(fe, 2, [](Point p) { return p.x * p.x * p.x; });
    const double error = estimate_by_recovery(fe, ScalarProblem{}, u).error;
    CHECK(error * error == doctest::Approx(6 * std::pow(1. / 6, 5) / 20));
  }

  TEST_CASE("the squares of the indicators add up to the estimate") {
    const Mesh mesh = mixed_square(7, 5);
    const FeMesh fe = straight_fe_mesh(mesh);
    const auto u = interpolant(fe, 1, [](Point p) { return std::exp(3 * p.x) * p.y; });
    ScalarProblem problem;
    problem.source = 5.;
    for (const auto& estimate :
         {estimate_by_recovery(fe, problem, u), estimate_by_residual(fe, problem, u)}) {
      REQUIRE(estimate.indicators.size() == fe.element_count());
      double sum = 0;
      for (const double indicator : estimate.indicators) sum += indicator * indicator;
      CHECK(std::sqrt(sum) == doctest::Approx(estimate.error));
      CHECK(estimate.error > 0.1);
    }
  }

  TEST_CASE("the reaction energy counts each region with its coefficient") {
    const Mesh mesh = with_two_regions(mixed_square(4, 4));
    const FeMesh fe = straight_fe_mesh(mesh);
    ScalarProblem problem;
    CHECK(reaction_energy(fe, problem, interpolant(fe, 1, [](Point) { return 1.; })) == 0);
    problem.reaction.set(2, [](Point p) { return p.y; });
    // int_{1/2}^1 x^2 int_0^1 y = 7/24 * 1/2.
    CHECK(reaction_energy(fe, problem, interpolant(fe, 1, [](Point p) { return p.x; })) ==
          doctest::Approx(7. / 48));
  }

  TEST_CASE("an interface of unequal diffusion adds no error of its own") {
    // a u' continuous: slopes 1 and 1/100.
    const Mesh mesh = with_two_regions(square_mesh(6));
    const FeMesh fe = straight_fe_mesh(mesh);
    ScalarProblem problem;
    problem.diffusion.set(2, 100.);
    const auto u =
        interpolant(fe, 1, [](Point p) { return p.x < 0.5 ? p.x : 0.5 + (p.x - 0.5) / 100; });
    CHECK(estimate_by_recovery(fe, problem, u).error < 1e-12);
    CHECK(estimate_by_residual(fe, problem, u).indicators.at(30) < 1e-12);
  }
}

TEST_SUITE("convergence") {
  TEST_CASE("the effectivity tends to one on a smooth problem with all scalar elements") {
    for (const int order : {1, 2}) {
      CAPTURE(order);
      CHECK(on_sine(perturbed_mesh(24, 0.25, 9), order) == doctest::Approx(1).epsilon(0.03));
      CHECK(on_sine(square_quads(24, 24), order) == doctest::Approx(1).epsilon(0.03));
      CHECK(on_sine(perturbed(square_quads(24, 24), 24, 24, 0.2, 3), order) ==
            doctest::Approx(1).epsilon(0.03));
      CHECK(on_sine(perturbed(mixed_square(24, 24), 24, 24, 0.2, 3), order) ==
            doctest::Approx(1).epsilon(0.03));
      CHECK(on_sine(three_quads_of(perturbed_mesh(12, 0.2, 9)), order) ==
            doctest::Approx(1).epsilon(0.04));
    }
  }

  TEST_CASE("on stretched layer meshes the estimate sees the layer and gets better with n") {
    for (const int order : {1, 2}) {
      CAPTURE(order);
      const double coarse = on_layer(square_mesh(16), 16, order);
      const double fine = on_layer(square_mesh(64), 64, order);
      CHECK(coarse > 0.65);
      CHECK(fine > coarse);
      CHECK(fine == doctest::Approx(0.95).epsilon(0.07));
      CHECK(on_layer(square_quads(48, 48), 48, order) == doctest::Approx(0.95).epsilon(0.15));
      CHECK(on_layer(mixed_square(48, 48), 48, order) == doctest::Approx(0.95).epsilon(0.15));
    }
  }
}
