// References: FE.md 3.2 (closed forms) and 3.3 (references.json; the mean of w under q = 1 is twice
// the energy).
#include <cmath>

#include <doctest/doctest.h>

#include "adapt/goal.hpp"
#include "mesher/geometry/error.hpp"
#include "tests/adapt/flux_data.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

const Goal kWhole{Goal::Kind::region_mean, {}, 0, 1};
const Goal kRightForce{Goal::Kind::curve_flux, {}, 0, kRight};

struct Judged {
  double value = 0, estimate = 0;

  double effectivity(double exact) const { return estimate / (exact - value); }
};

Judged judged(const Mesh& mesh, const PlateProblem& problem, PlateElement element,
              const Goal& goal) {
  const FeMesh fe = straight_fe_mesh(mesh);
  PlateOptions options;
  options.element = element;
  const PlateProblem dual = dual_problem(fe, problem, goal);
  const PlateSolution u = solve_plate(fe, problem, options), z = solve_plate(fe, dual, options);
  const FluxSamples primal = plate_flux(fe, problem, u), weight = plate_flux(fe, dual, z);
  const TyingMismatch tying{tying_mismatch(fe, problem, u, primal, goal),
                            tying_mismatch(fe, problem, z, weight, goal)};
  return {goal_value(fe, problem, u, goal), estimate_goal(fe, primal, RecoveredFlux(fe, primal),
                                                          weight, RecoveredFlux(fe, weight), tying)
                                                .error};
}

/// A strip along x: symmetry below and above.
PlateProblem strip(double thickness, SupportKind left, SupportKind right, RegionCoefficient load) {
  PlateProblem problem = plate(unit_bending(thickness), std::move(load));
  problem.supports = {{kLeft, left, {}},
                      {kRight, right, {}},
                      {kBottom, SupportKind::symmetry, {}},
                      {kTop, SupportKind::symmetry, {}}};
  return problem;
}

std::vector<Mesh> meshes(Index n) {
  return {perturbed_mesh(n, 0.15, 9), square_quads(n, n),
          perturbed(square_quads(n, n), n, n, 0.15, 3),
          perturbed(mixed_square(n, n), n, n, 0.15, 3)};
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the dual of a plate keeps the supports without loads and deflections") {
    const Mesh mesh = square_mesh(4);
    const FeMesh fe = straight_fe_mesh(mesh);
    PlateProblem problem = strip(0.1, SupportKind::clamped, SupportKind::soft_support, 3.);
    problem.supports[0].deflection = 0.5;
    problem.edge_loads = {{kTop, 1., 2., 3.}};
    problem.point_loads = {{{0.5, 0.5}, 7}};
    problem.point_supports = {{{0.25, 0.25}, 0.3, true}};
    const PlateProblem dual = dual_problem(fe, problem, {Goal::Kind::region_mean, {}, 0, 1});
    CHECK(dual.load.in(1)({}) == doctest::Approx(1));
    CHECK(dual.supports[0].kind == SupportKind::clamped);
    CHECK(dual.supports[0].deflection.is_zero());
    CHECK(dual.edge_loads.empty());
    CHECK(dual.point_loads.empty());
    CHECK(dual.point_supports.at(0).deflection == 0);
    CHECK(dual.point_supports[0].holds_rotations);
    CHECK(dual.material.thickness == 0.1);
  }

  TEST_CASE("the dual of a force is held at -1 and in equal parts where supports meet") {
    const Mesh mesh = square_mesh(4);
    const FeMesh fe = straight_fe_mesh(mesh);
    PlateProblem problem = plate(unit_bending(0.1), 1.);
    support_all_sides(SupportKind::soft_support, problem);
    problem.point_supports = {{{1, 0.5}, 0, false}, {{1, 1}, 0, false}, {{0.5, 0.5}, 0, false}};
    const PlateProblem dual = dual_problem(fe, problem, kRightForce);
    CHECK(dual.load.is_zero());
    for (const auto& [tag, kind, deflection] : dual.supports) {
      CHECK(deflection({1, 0}) == -0.5);
      CHECK(deflection({1, 1}) == doctest::Approx(-1. / 3));
      CHECK(deflection({1, 0.5}) == -0.5);
      CHECK(deflection({1, 0.25}) == (tag == kRight ? -1 : 0));
      CHECK(deflection({0, 0}) == (tag == kRight ? -1 : 0));
    }
    CHECK(dual.point_supports[0].deflection == -0.5);
    CHECK(dual.point_supports[1].deflection == doctest::Approx(-1. / 3));
    CHECK(dual.point_supports[2].deflection == 0);
    // The solver accepts them where they meet.
    CHECK(solve_plate(fe, dual).work > 0);
  }

  TEST_CASE("the force on a support of a statically determinate plate is exact") {
    // q = x on simple supports: 1/6 and 1/3.
    const auto load = [](Point p) { return p.x; };
    const PlateProblem problem =
        strip(0.05, SupportKind::soft_support, SupportKind::soft_support, {load});
    for (const Mesh& mesh : meshes(4)) {
      const Judged force = judged(mesh, problem, PlateElement::mitc, kRightForce);
      CHECK(force.value == doctest::Approx(-1. / 3).epsilon(1e-9));
      CHECK(std::abs(force.estimate) < 1e-10);
    }
  }

  TEST_CASE("tied strains are left out where they would not help") {
    const Mesh mesh = square_mesh(4);
    const FeMesh fe = straight_fe_mesh(mesh);
    PlateProblem problem = plate(unit_bending(0.1), 1.);
    support_all_sides(SupportKind::soft_support, problem);
    const auto mismatch = [&](PlateElement element, const Goal& goal) {
      PlateOptions options;
      options.element = element;
      const PlateSolution u = solve_plate(fe, problem, options);
      const FluxSamples samples = plate_flux(fe, problem, u);
      return tying_mismatch(fe, problem, u, samples, goal).size() / samples.points.size();
    };
    CHECK(mismatch(PlateElement::mitc, kWhole) == 2);
    CHECK(mismatch(PlateElement::mitc, kRightForce) == 0);
    CHECK(mismatch(PlateElement::arnold_falk, kWhole) == 0);
  }

  TEST_CASE("a force that the solution lacks is refused and no mean taken for it") {
    const Mesh mesh = square_mesh(4);
    const FeMesh fe = straight_fe_mesh(mesh);
    PlateProblem problem = plate(unit_bending(0.1), 1.);
    support_all_sides(SupportKind::soft_support, problem);
    PlateSolution solution = solve_plate(fe, problem);
    CHECK(goal_value(fe, problem, solution, kRightForce) == doctest::Approx(-0.25).epsilon(1e-6));
    std::erase_if(solution.reactions, [](const PlateReaction& r) { return r.tag == kRight; });
    CHECK_THROWS_WITH_AS(goal_value(fe, problem, solution, kRightForce),
                         doctest::Contains("has no reaction there"), InputError);
  }

  TEST_CASE("plate goals that make no sense are refused") {
    const Mesh mesh = square_mesh(2);
    const FeMesh fe = straight_fe_mesh(mesh);
    const PlateProblem problem = strip(0.1, SupportKind::clamped, SupportKind::free, 1.);
    const PlateSolution u = solve_plate(fe, problem);
    for (const Index tag : {kRight, kBottom}) {
      const Goal goal{Goal::Kind::curve_flux, {}, 0, tag};
      CHECK_THROWS_WITH_AS(dual_problem(fe, problem, goal), doctest::Contains("not held"),
                           InputError);
      CHECK_THROWS_WITH_AS(goal_value(fe, problem, u, goal), doctest::Contains("not held"),
                           InputError);
    }
    CHECK_THROWS_WITH_AS(dual_problem(fe, problem, {Goal::Kind::curve_flux, {}, 0, 44}),
                         doctest::Contains("tag 44"), InputError);
    CHECK_THROWS_AS(dual_problem(fe, problem, {Goal::Kind::patch_mean, {3, 3}, 0.1, 0}),
                    InputError);
  }
}

TEST_SUITE("convergence") {
  TEST_CASE("the estimated error of the prop's force of a clamped strip is the true one") {
    // Deflections of the cantilever, 1 / 8 + 1 / (2 S), and of a unit force, 1 / 3 + 1 / S.
    const double t = 0.1, s = 3.5 / (t * t);
    const double force = -(1. / 8 + 1 / (2 * s)) / (1. / 3 + 1 / s);
    const PlateProblem problem = strip(t, SupportKind::clamped, SupportKind::soft_support, 1.);
    for (const Mesh& mesh : meshes(12)) {
      CAPTURE(mesh.triangles.size());
      const Judged mitc = judged(mesh, problem, PlateElement::mitc, kRightForce);
      CHECK(mitc.value == doctest::Approx(force).epsilon(2e-5));
      if (std::abs(mitc.value - force) > 1e-10)
        CHECK(mitc.effectivity(force) == doctest::Approx(1).epsilon(0.1));
      if (!mesh.triangles.empty()) continue;
      CHECK(judged(mesh, problem, PlateElement::mitc4, kRightForce).effectivity(force) ==
            doctest::Approx(1).epsilon(0.05));
    }
  }

  TEST_CASE("the estimated error of the mean deflection is the true one") {
    const double t = 0.1;
    for (const auto& [kind, energy] : {std::pair{SupportKind::soft_support, 9.8221422189e-4},
                                       std::pair{SupportKind::hard_support, 9.0146133913e-4}}) {
      PlateProblem problem = plate(unit_bending(t), 1.);
      support_all_sides(kind, problem);
      for (const Mesh& mesh : meshes(12)) {
        CAPTURE(mesh.triangles.size());
        const double effectivity =
            judged(mesh, problem, PlateElement::mitc, kWhole).effectivity(2 * energy);
        CHECK(effectivity > 0.75);
        CHECK(effectivity < 1.25);
      }
    }
  }

  TEST_CASE("the estimated error of the mean deflection of a thin plate with its layers is near") {
    const double t = 0.01, mean = 2 * 8.6000949776e-4;
    PlateProblem problem = plate(unit_bending(t), 1.);
    support_all_sides(SupportKind::soft_support, problem);
    const auto effectivity = [&](const Mesh& mesh) {
      return judged(shishkin(mesh, 16, t / std::sqrt(10.)), problem, PlateElement::mitc, kWhole)
          .effectivity(mean);
    };
    CHECK(effectivity(square_quads(16, 16)) == doctest::Approx(1).epsilon(0.05));
    CHECK(effectivity(square_mesh(16)) == doctest::Approx(0.65).epsilon(0.1));
  }

  TEST_CASE("the estimated error of a patch mean of the deflection is the true one") {
    // Hard supports under q = sin sin: w = (1 + 2 pi^2 / S) / (4 pi^4) sin sin.
    const double t = 0.1, w = 0.002711240111731567;
    const auto sines = [](Point p) { return std::sin(kPi * p.x) * std::sin(kPi * p.y); };
    PlateProblem problem = plate(unit_bending(t), {sines});
    support_all_sides(SupportKind::hard_support, problem);
    const Goal goal{Goal::Kind::patch_mean, {0.4, 0.55}, 0.2, 0};
    const Mesh fine = square_mesh(48);
    const FeMesh fe = straight_fe_mesh(fine);
    ScalarSolution exact;
    exact.field = interpolant(fe, 2, [&](Point p) { return w * sines(p); });
    const double mean = goal_value(fe, ScalarProblem{}, exact, goal);
    for (const Mesh& mesh : meshes(12)) {
      CAPTURE(mesh.triangles.size());
      const double effectivity = judged(mesh, problem, PlateElement::mitc, goal).effectivity(mean);
      CHECK(effectivity > 0.75);
      CHECK(effectivity < 1.3);
      if (mesh.triangles.empty())
        CHECK(judged(mesh, problem, PlateElement::mitc4, goal).effectivity(mean) ==
              doctest::Approx(1).epsilon(0.1));
    }
  }
}
