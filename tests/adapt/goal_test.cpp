#include "adapt/goal.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "mesher/generate.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/mesh/boundary_domain.hpp"
#include "tests/adapt/flux_data.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

GoalEstimate estimate(const FeMesh& mesh, const ScalarProblem& problem, const ScalarField& u,
                      const ScalarField& z) {
  const FluxSamples primal = scalar_flux(mesh, problem, u), dual = scalar_flux(mesh, problem, z);
  return estimate_goal(mesh, primal, RecoveredFlux(mesh, primal), dual, RecoveredFlux(mesh, dual));
}

GoalEstimate with_weights(std::vector<double> primal, std::vector<double> dual) {
  return {0, {}, std::move(primal), std::move(dual)};
}

/// Layers of width 0.03 along all sides and the mean over a patch that reaches into one of them.
struct LayerPatch {
  static constexpr double kEps = 0.03;
  ExactSolution exact = product_layer(kEps * kEps, 1);
  ScalarProblem problem = dirichlet_problem(exact, kEps* kEps, 1);
  Goal goal{Goal::Kind::patch_mean, {0.9, 0.5}, 0.08, 0};

  ScalarSolution solved(const FeMesh& mesh, const ScalarProblem& of, int order = 1) const {
    ScalarOptions options;
    options.order = order;
    return solve_scalar(mesh, of, options);
  }

  double reference() const {
    const Mesh mesh = shishkin(square_quads(64, 64), 64, kEps);
    const FeMesh fe = straight_fe_mesh(mesh);
    return goal_value(fe, problem, solved(fe, problem, 2), goal);
  }

  PrincipalField density(const FeMesh& fe, const ScalarField& u, bool use_goal) const {
    const FieldHessians own = hessians_of(fe.mesh, u.values, 1);
    if (!use_goal) return metric_density(fe.mesh, own, {});
    const ScalarField z = solved(fe, dual_problem(fe, problem, goal)).field;
    const std::vector<Hessian> weighted =
        goal_hessians(own, hessians_of(fe.mesh, z.values, 1), estimate(fe, problem, u, z));
    return metric_density(fe.mesh, {weighted}, {.p = 1});
  }

  /// Three cycles with the metric of the solution or of the goal.
  Mesh adapted(bool use_goal) const {
    Mesh mesh = square_mesh(16);
    const Domain domain = domain_from_mesh(mesh);
    for (int cycle = 0; cycle < 3; ++cycle) {
      const FeMesh fe = straight_fe_mesh(mesh);
      const PrincipalField shape = density(fe, solved(fe, problem).field, use_goal);
      const ScaledMetric metric =
          scale_metric(mesh, shape, expected_vertices, 400, {.stretch = 100, .gradation = 2});
      Mesh next = generate(domain, mesh, metric.field, generate_options(Preset::best)).mesh;
      mesh = std::move(next);
    }
    return mesh;
  }

  double value_on(const Mesh& mesh) const {
    const FeMesh fe = straight_fe_mesh(mesh);
    return goal_value(fe, problem, solved(fe, problem), goal);
  }
};

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the goal estimate is the integral of the product of both recovered errors") {
    // u = x^2 on 8 columns: grad e = 2x - (x_i + x_{i+1}), its square integrates to 1 / (3 8^2).
    for (const Mesh& mesh : {square_mesh(8, 3), square_quads(8, 3)}) {
      const FeMesh fe = straight_fe_mesh(mesh);
      ScalarProblem problem;
      problem.diffusion = 4.;
      const auto u = interpolant(fe, 1, [](Point p) { return p.x * p.x; });
      const auto z = interpolant(fe, 1, [](Point p) { return -3 * p.x * p.x + p.y * p.y; });
      const GoalEstimate goal = estimate(fe, problem, u, z);
      CHECK(goal.error == doctest::Approx(-3 * 4. / (3 * 64)));
      double sum = 0;
      for (const double indicator : goal.indicators) sum += indicator;
      CHECK(goal.indicators.size() == fe.element_count());
      CHECK(sum == doctest::Approx(-goal.error));
      // Root mean squares, equal in all elements: of z from both directions.
      for (const double w : goal.primal_weights) CHECK(w == doctest::Approx(2 / std::sqrt(3 * 64)));
      for (const double w : goal.dual_weights)
        CHECK(w == doctest::Approx(2 / std::sqrt(3.) * std::hypot(3. / 8, 1. / 3)));
    }
  }

  TEST_CASE("errors at right angles to each other leave the goal exact") {
    const Mesh mesh = square_mesh(6);
    const FeMesh fe = straight_fe_mesh(mesh);
    const auto u = interpolant(fe, 1, [](Point p) { return p.x * p.x; });
    const auto z = interpolant(fe, 1, [](Point p) { return p.y * p.y; });
    const GoalEstimate goal = estimate(fe, {}, u, z);
    CHECK(std::abs(goal.error) < 1e-12);
    CHECK(goal.primal_weights[24] > 0.05);
  }

  TEST_CASE("a mismatch of tied shear strains lowers the goal estimate by its work") {
    // Constant stresses (0, 0, 0, 2, 3) of the solution, of the dual (0, 0, 0, 1, 0).
    const Mesh mesh = square_quads(3, 3);
    const FeMesh fe = straight_fe_mesh(mesh);
    FluxSamples u = samples_of(fe, 1, [](Index, Point) { return Vector{}; });
    u.components = 5;
    u.values.assign(5 * u.points.size(), 0);
    FluxSamples z = u;
    TyingMismatch tying;
    for (std::size_t s = 0; s < u.points.size(); ++s) {
      u.values[5 * s + 3] = 2;
      u.values[5 * s + 4] = 3;
      z.values[5 * s + 3] = 1;
      tying.primal.insert(tying.primal.end(), {0.5, 100});
      tying.dual.insert(tying.dual.end(), {0.25, -1});
    }
    const RecoveredFlux primal(fe, u), dual(fe, z);
    // -(2 / 4 - 3) - 1 / 2 over the unit square.
    CHECK(estimate_goal(fe, u, primal, z, dual, tying).error == doctest::Approx(2));
    CHECK(std::abs(estimate_goal(fe, u, primal, z, dual).error) < 1e-12);
  }

  TEST_CASE("Hessians of a goal are those of solution and dual weighted crosswise") {
    const FieldHessians u{{{3, 0, 0}, {1, 0, -2}}, {{4, 0, 0}, {0, 0, 0}}};
    const FieldHessians z{{{0, 2, 0}, {0, 0, 0}}};
    const auto sum = goal_hessians(u, z, with_weights({7, 1e-9}, {10, 5}));
    // |H_u| = diag(5, 0) and diag(1, 2); |H_z| = 2 I and 0; the weight 1e-9 becomes 7e-3.
    CHECK(sum[0].xx == doctest::Approx(10 * 5 + 7 * 2));
    CHECK(sum[0].xy == doctest::Approx(0));
    CHECK(sum[0].yy == doctest::Approx(7 * 2));
    CHECK(sum[1].xx == doctest::Approx(5));
    CHECK(sum[1].yy == doctest::Approx(10));
    const auto lifted = goal_hessians(z, {{{0, 0, 0}, {1, 0, 0}}}, with_weights({7, 1e-9}, {1, 1}));
    CHECK(lifted[1].xx == doctest::Approx(7e-3));
  }

  TEST_CASE("Hessians of a goal that are missing or not finite are refused") {
    const FieldHessians good{{{1, 0, 1}, {1, 0, 1}}};
    FieldHessians bad = good;
    bad[0][1].xy = std::nan("");
    const GoalEstimate goal = with_weights({1, 1}, {1, 1});
    CHECK_THROWS_WITH_AS(goal_hessians({}, good, goal), doctest::Contains("the solution"),
                         InputError);
    CHECK_THROWS_WITH_AS(goal_hessians(good, {{{1, 0, 1}}}, goal),
                         doctest::Contains("the dual solution has 1 Hessians"), InputError);
    CHECK_THROWS_WITH_AS(goal_hessians(good, bad, goal), doctest::Contains("vertex 2"), InputError);
  }
}

TEST_SUITE("convergence") {
  TEST_CASE("the goal metric gets the mean over a patch right with fewer vertices than that of u") {
    const LayerPatch layer;
    const double exact = layer.reference();
    const Mesh of_goal = layer.adapted(true), of_solution = layer.adapted(false);
    CHECK(of_goal.points.size() <= of_solution.points.size());
    CHECK(of_goal.points.size() > 350);
    CHECK(std::abs(layer.value_on(of_goal) - exact) <
          0.2 * std::abs(layer.value_on(of_solution) - exact));
  }
}
