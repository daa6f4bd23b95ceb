#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "adapt/goal_mean.hpp"
#include "mesher/geometry/error.hpp"
#include "tests/adapt/flux_data.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

constexpr double kPi = std::numbers::pi;

const Goal kPatch{Goal::Kind::patch_mean, {0.4, 0.55}, 0.3, 0};
const Goal kRightHalf{Goal::Kind::region_mean, {}, 0, 2};
const Goal kLeftFlux{Goal::Kind::curve_flux, {}, 0, kLeft};

struct Judged {
  double value = 0, estimate = 0;

  double effectivity(double exact) const { return estimate / (exact - value); }
};

Judged judged(const FeMesh& mesh, const ScalarProblem& problem, int order, const Goal& goal) {
  ScalarOptions options;
  options.order = order;
  const ScalarSolution u = solve_scalar(mesh, problem, options);
  const ScalarProblem dual = dual_problem(mesh, problem, goal);
  const FluxSamples primal = scalar_flux(mesh, problem, u.field);
  const FluxSamples weight = scalar_flux(mesh, dual, solve_scalar(mesh, dual, options).field);
  return {
      goal_value(mesh, problem, u, goal),
      estimate_goal(mesh, primal, RecoveredFlux(mesh, primal), weight, RecoveredFlux(mesh, weight))
          .error};
}
Judged judged(const Mesh& mesh, const ScalarProblem& problem, int order, const Goal& goal) {
  return judged(straight_fe_mesh(mesh), problem, order, goal);
}

/// J of a known function.
double exact_mean(const Goal& goal, const ScalarFunction& u) {
  const Mesh mesh = square_mesh(48);
  const FeMesh fe = straight_fe_mesh(mesh);
  return mean_of(fe, goal_mean(fe, goal), [&](const Element& element, ReferencePoint at) {
    return u(map_at(element, at).x);
  });
}

/// u = sin(pi x / 2) (1 + cos(pi y)) of -laplace u + u = f: 0 at the left, no flux elsewhere.
ScalarProblem held_at_left() {
  ScalarProblem problem;
  problem.reaction = 1.;
  problem.source = [](Point p) {
    const double s = std::sin(kPi / 2 * p.x), c = std::cos(kPi * p.y);
    return s * (1 + c) * (1 + kPi * kPi / 4) + s * c * kPi * kPi;
  };
  problem.dirichlet = {{kLeft, 0.}};
  return problem;
}

std::vector<Mesh> meshes(Index n) {
  return {perturbed_mesh(n, 0.25, 9), square_quads(n, n),
          perturbed(square_quads(n, n), n, n, 0.2, 3), perturbed(mixed_square(n, n), n, n, 0.2, 3)};
}

/// 0 on all sides, those in `sides` in this order.
ScalarProblem held_on(std::initializer_list<Index> sides) {
  ScalarProblem problem;
  problem.source = 1.;
  for (const Index side : sides) problem.dirichlet.push_back({side, 0.});
  return problem;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the dual of a scalar mean keeps the conditions without their data") {
    const Mesh mesh = with_two_regions(square_mesh(4));
    const FeMesh fe = straight_fe_mesh(mesh);
    ScalarProblem problem;
    problem.diffusion.set(2, 7.);
    problem.reaction = [](Point p) { return p.x; };
    problem.source = 5.;
    problem.dirichlet = {{kLeft, 3.}};
    problem.fluxes = {{kRight, 2., 0.5}, {kTop, 4., 0.}};
    problem.points = {{{0.5, 0.5}, 9}};
    const ScalarProblem dual = dual_problem(fe, problem, kRightHalf);
    CHECK(dual.diffusion.in(2)({}) == 7);
    CHECK(dual.reaction.in(1)({0.25, 0}) == 0.25);
    CHECK(dual.source.in(1)({}) == 0);
    CHECK(dual.source.in(2)({}) == doctest::Approx(2));
    CHECK(dual.dirichlet.at(0).value.is_zero());
    REQUIRE(dual.fluxes.size() == 1);
    CHECK(dual.fluxes[0].tag == kRight);
    CHECK(dual.fluxes[0].flux.is_zero());
    CHECK(dual.fluxes[0].transfer({}) == 0.5);
    CHECK(dual.points.at(0).value == 0);
  }

  TEST_CASE("the dual of a flux is held at -1 and where curves meet at the share of the reaction") {
    // Edges of length 1/4 below and 1/8 at the left.
    const Mesh mesh = square_mesh(4, 8);
    const FeMesh fe = straight_fe_mesh(mesh);
    for (const auto& problem : {held_on({kLeft, kBottom}), held_on({kBottom, kLeft})})
      for (const auto& [tag, value] : dual_problem(fe, problem, kLeftFlux).dirichlet) {
        CHECK(value({0, 0}) == doctest::Approx(-1. / 3));
        CHECK(value({0, 0.5}) == (tag == kLeft ? -1 : 0));
        CHECK(value({0, 1}) == (tag == kLeft ? -1 : 0));
      }
  }

  TEST_CASE("edges of a held curve inside count to its share from both sides") {
    // Two edges of 1/8 (two sides of one) against two edges of 1/4.
    const Mesh mesh = with_middle_curve(square_mesh(4, 8), 1);
    const FeMesh fe = straight_fe_mesh(mesh);
    const Goal goal{Goal::Kind::curve_flux, {}, 0, kMiddle};
    const ScalarProblem dual = dual_problem(fe, held_on({kBottom, kMiddle}), goal);
    CHECK(dual.dirichlet[0].value({0.5, 0}) == doctest::Approx(-1. / 3));
  }

  TEST_CASE("goals of a linear solution are exact and their estimates zero") {
    const Mesh mesh = with_two_regions(perturbed(mixed_square(8, 8), 8, 8, 0.2, 8));
    ScalarProblem problem;
    problem.diffusion = 3.;
    const auto plane = [](Point p) { return 2 * p.x - p.y; };
    for (const Index side : {kBottom, kRight, kTop, kLeft})
      problem.dirichlet.push_back({side, plane});
    for (const int order : {1, 2}) {
      const Judged patch = judged(mesh, problem, order, kPatch);
      CHECK(patch.value == doctest::Approx(0.25).epsilon(1e-4));
      CHECK(std::abs(patch.estimate) < 1e-12);
      const Judged flux = judged(mesh, problem, order, kLeftFlux);
      CHECK(flux.value == doctest::Approx(-6));
      CHECK(std::abs(flux.estimate) < 1e-11);
    }
  }

  TEST_CASE("a flux whose dual is linear is exact whatever the solution") {
    // -u'' = 6x between u = 0 at both ends: u = x - x^3, outward flux at the left -1.
    ScalarProblem problem = held_on({kLeft, kRight});
    problem.source = [](Point p) { return 6 * p.x; };
    for (const Mesh& mesh : meshes(5)) {
      const Judged flux = judged(mesh, problem, 1, kLeftFlux);
      CHECK(flux.value == doctest::Approx(-1).epsilon(1e-9));
      CHECK(std::abs(flux.estimate) < 1e-12);
    }
  }

  TEST_CASE("the estimate of a flux does not depend on the order of the conditions") {
    const Mesh mesh = perturbed_mesh(8, 0.2, 4);
    const Judged a = judged(mesh, held_on({kLeft, kBottom, kRight}), 1, kLeftFlux);
    const Judged b = judged(mesh, held_on({kRight, kBottom, kLeft}), 1, kLeftFlux);
    CHECK(a.value == doctest::Approx(b.value).epsilon(1e-12));
    CHECK(a.estimate == doctest::Approx(b.estimate).epsilon(1e-9));
    CHECK(a.estimate != 0);
  }

  TEST_CASE("scalar goals that make no sense are refused") {
    const Mesh mesh = square_mesh(2);
    const FeMesh fe = straight_fe_mesh(mesh);
    const ScalarProblem problem = held_on({kBottom});
    const ScalarSolution u = solve_scalar(fe, problem);
    CHECK_THROWS_WITH_AS(dual_problem(fe, problem, kLeftFlux), doctest::Contains("not prescribed"),
                         InputError);
    CHECK_THROWS_WITH_AS(goal_value(fe, problem, u, kLeftFlux), doctest::Contains("not prescribed"),
                         InputError);
    CHECK_THROWS_WITH_AS(dual_problem(fe, problem, {Goal::Kind::curve_flux, {}, 0, 44}),
                         doctest::Contains("tag 44"), InputError);
    CHECK_THROWS_AS(dual_problem(fe, problem, kRightHalf), InputError);
    ScalarProblem flow = problem;
    flow.velocity_x = 1.;
    CHECK_THROWS_WITH_AS(dual_problem(fe, flow, kPatch), doctest::Contains("convection"),
                         InputError);
  }
}

TEST_SUITE("convergence") {
  TEST_CASE("the estimated error of a patch mean is the true one with all scalar elements") {
    const ExactSolution exact = sine_product(1, 1);
    const ScalarProblem problem = dirichlet_problem(exact, 1, 1);
    const double mean = exact_mean(kPatch, exact.value);
    for (const int order : {1, 2})
      for (const Mesh& mesh : meshes(24)) {
        CAPTURE(order);
        CAPTURE(mesh.triangles.size());
        CHECK(judged(mesh, problem, order, kPatch).effectivity(mean) ==
              doctest::Approx(1).epsilon(order == 1 ? 0.05 : 0.3));
      }
  }

  TEST_CASE("a patch inside one element has an estimate of the right size") {
    const ExactSolution exact = sine_product(1, 1);
    const ScalarProblem problem = dirichlet_problem(exact, 1, 1);
    const Goal goal{Goal::Kind::patch_mean, {0.4, 0.55}, 0.01, 0};
    const double mean = exact_mean(goal, exact.value);
    for (const Mesh& mesh : meshes(12)) {
      CAPTURE(mesh.triangles.size());
      const double effectivity = judged(mesh, problem, 1, goal).effectivity(mean);
      CHECK(effectivity > 0.33);
      CHECK(effectivity < 3);
    }
  }

  TEST_CASE("the estimated error of a region mean is the true one") {
    const ScalarProblem problem = dirichlet_problem(sine_product(1, 1), 1, 1);
    for (const int order : {1, 2})
      for (const Mesh& mesh : {square_mesh(24), square_quads(24, 24)})
        CHECK(judged(with_two_regions(mesh), problem, order, kRightHalf)
                  .effectivity(4 / (kPi * kPi)) == doctest::Approx(1).epsilon(0.2));
  }

  TEST_CASE("the estimated error of a flux through a curve by itself is the true one") {
    for (const Mesh& mesh : meshes(16)) {
      CAPTURE(mesh.triangles.size());
      const Judged linear = judged(mesh, held_at_left(), 1, kLeftFlux);
      CHECK(linear.effectivity(-kPi / 2) == doctest::Approx(1).epsilon(0.05));
      CHECK(std::abs(linear.value + kPi / 2) < 2e-3);
      if (mesh.quads.empty()) continue;
      CHECK(judged(mesh, held_at_left(), 2, kLeftFlux).effectivity(-kPi / 2) ==
            doctest::Approx(1).epsilon(0.1));
    }
  }

  TEST_CASE("the estimated error of a flux between corners is the true one on regular meshes") {
    // int -pi sin(pi y) = -2.
    const ScalarProblem problem = dirichlet_problem(sine_product(1, 1), 1, 1);
    for (const int order : {1, 2})
      CHECK(judged(square_quads(32, 32), problem, order, kLeftFlux).effectivity(-2) ==
            doctest::Approx(1).epsilon(0.12));
  }
}
