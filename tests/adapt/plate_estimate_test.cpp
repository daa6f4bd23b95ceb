#include <cmath>

#include <doctest/doctest.h>

#include "adapt/reference.hpp"
#include "tests/adapt/flux_data.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// A quarter of the unit square plate, the symmetry axes right and on top.
PlateProblem quarter_plate(double thickness, SupportKind support) {
  PlateProblem problem = plate(unit_bending(thickness), 1.);
  problem.supports = {{kBottom, support, {}},
                      {kLeft, support, {}},
                      {kRight, SupportKind::symmetry, {}},
                      {kTop, SupportKind::symmetry, {}}};
  return problem;
}

/// The quarter with half of the intervals in the layers, whose width is t / sqrt(12 k).
Mesh layered_quarter(const Mesh& mesh, Index n, double thickness) {
  const double width = std::min(0.25, 2 * std::log(n) * thickness / std::sqrt(10.));
  const auto graded = [width](double s) {
    return s < 0.5 ? 2 * s * width : width + (2 * s - 1) * (0.5 - width);
  };
  return mapped(mesh, [&](Point p) { return Point{graded(p.x), graded(p.y)}; });
}

/// A solution on 44 x 44 quadrilaterals that shrink towards the supports.
struct Overkill {
  PlateProblem problem;
  Mesh mesh;
  FeMesh fe;
  PlateSolution solution;
  FluxSamples samples;

  Overkill(double thickness, SupportKind support)
      : problem(quarter_plate(thickness, support)),
        mesh(mapped(square_quads(44, 44),
                    [d = 0.5 * thickness](Point p) {
                      const double rate = std::log1p(0.5 / d);
                      return Point{d * std::expm1(rate * p.x), d * std::expm1(rate * p.y)};
                    })),
        fe(straight_fe_mesh(mesh)),
        solution(solve_plate(fe, problem)),
        samples(plate_flux(fe, problem, solution)) {}

  double effectivity(const Mesh& coarse, PlateElement element) const {
    const FeMesh coarse_fe = straight_fe_mesh(coarse);
    PlateOptions options;
    options.element = element;
    const PlateSolution u = solve_plate(coarse_fe, problem, options);
    const double error = energy_of_difference(samples, coarse_fe, [&](const Location& place) {
      return plate_flux_at(coarse_fe, problem, u, place.element, place.at);
    });
    return estimate_by_recovery(coarse_fe, problem, u).error / error;
  }
};

/// The bars of the effectivity of plates, t >= 0.01.
void check_effectivity(double effectivity) {
  CHECK(effectivity >= 0.85);
  CHECK(effectivity <= 1.2);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("pure bending and twisting of a plate has no estimated error") {
    // w quadratic, theta = grad w, no load: constant moments.
    const Mesh mesh = perturbed(mixed_square(4, 4), 4, 4, 0.2, 5);
    const FeMesh fe = straight_fe_mesh(mesh);
    const PlateProblem problem = plate(unit_bending(0.01));
    PlateSolution solution;
    solution.dofs = make_dof_map(fe, plate_layout(PlateElement::mitc));
    const auto theta = [](Point p) { return Vector{2 * p.x + 3 * p.y, 3 * p.x - p.y}; };
    const auto add = [&](Point p) {
      const double w = p.x * p.x + 3 * p.x * p.y - 0.5 * p.y * p.y;
      solution.values.insert(solution.values.end(), {w, theta(p).x, theta(p).y});
    };
    for (const Point& p : mesh.points) add(p);
    for (const Point& p : fe.edge_points) add(p);
    for (Index e = 0; e < fe.element_count(); ++e) {
      const Element element = element_at(fe, e);
      // Bubbles of triangles are zero, centres of quadrilaterals are nodes.
      const Vector inner =
          element.shape == Shape::triangle ? Vector{} : theta(map_at(element, {0, 0}).x);
      solution.inner.insert(solution.inner.end(), {inner.x, inner.y});
    }
    const ErrorEstimate estimate = estimate_by_recovery(fe, problem, solution);
    // D [4 + 1 - 2 nu 2 + 2 (1 - nu) 9] over the unit square.
    CHECK(estimate.energy * estimate.energy ==
          doctest::Approx(4 + 1 + 2 * 0.3 * 2 * -1 + 2 * 0.7 * 9));
    CHECK(estimate.relative() < 1e-9);
    CHECK(estimate.indicators.size() == fe.element_count());
  }
}

TEST_SUITE("convergence") {
  TEST_CASE("the effectivity on the layers of a soft-support plate lies in its bars") {
    const double t = 0.01;
    const Overkill overkill(t, SupportKind::soft_support);
    const auto mitc = [&](const Mesh& mesh, Index n) {
      return overkill.effectivity(layered_quarter(mesh, n, t), PlateElement::mitc);
    };
    check_effectivity(mitc(square_mesh(16), 16));
    check_effectivity(mitc(square_mesh(24), 24));
    check_effectivity(mitc(square_quads(16, 16), 16));
    check_effectivity(mitc(mixed_square(16, 16), 16));
    check_effectivity(mitc(perturbed_mesh(16, 0.12, 7), 16));
    check_effectivity(mitc(perturbed(square_quads(16, 16), 16, 16, 0.12, 7), 16));
  }

  TEST_CASE("the effectivity on a clamped plate lies in its bars with all plate elements") {
    const Overkill overkill(0.05, SupportKind::clamped);
    const auto quarter = [](const Mesh& mesh) {
      return mapped(mesh, [](Point p) { return 0.5 * p; });
    };
    check_effectivity(overkill.effectivity(quarter(square_mesh(8)), PlateElement::mitc));
    check_effectivity(overkill.effectivity(quarter(square_quads(12, 12)), PlateElement::mitc));
    check_effectivity(overkill.effectivity(quarter(square_quads(16, 16)), PlateElement::mitc4));
    check_effectivity(overkill.effectivity(quarter(square_mesh(16)), PlateElement::arnold_falk));
  }
}
