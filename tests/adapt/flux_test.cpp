#include "adapt/flux.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <doctest/doctest.h>

#include "adapt/reference.hpp"
#include "tests/adapt/flux_data.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

double square(double x) { return x * x; }

/// Half the squared norm of the samples over the strain energy of a plate held on all sides.
double energy_ratio(const Mesh& mesh, PlateElement element) {
  const FeMesh fe = straight_fe_mesh(mesh);
  PlateProblem problem = plate(unit_bending(0.1), [](Point p) { return 1 + p.x; });
  support_all_sides(SupportKind::soft_support, problem);
  PlateOptions options;
  options.element = element;
  const PlateSolution solution = solve_plate(fe, problem, options);
  return 0.5 * square(energy_of(plate_flux(fe, problem, solution))) / solution.energy.total();
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the stresses of a linear function are the root of a times its gradient") {
    const Mesh mesh = with_two_regions(square_mesh(4, 3));
    const FeMesh fe = straight_fe_mesh(mesh);
    ScalarProblem problem;
    problem.diffusion.set(2, 9.);
    const auto field = interpolant(fe, 1, [](Point p) { return 2 * p.x - p.y; });
    const FluxSamples samples = scalar_flux(fe, problem, field);
    CHECK(samples.components == 2);
    CHECK(samples.degree == 1);
    CHECK(samples.points.size() == 24);  // constant: one sample per triangle
    for (Index e = 0; e < fe.element_count(); ++e) {
      const double root = mesh.triangle_regions[e] == 2 ? 3 : 1;
      CHECK(samples.values[2 * e] == doctest::Approx(2 * root));
      CHECK(samples.values[2 * e + 1] == doctest::Approx(-root));
      const auto at = scalar_flux_at(fe, problem, field, element_at(fe, e), {0.2, 0.3});
      CHECK(at[0] == doctest::Approx(2 * root));
      CHECK(at[1] == doctest::Approx(-root));
    }
  }

  TEST_CASE("a coefficient that varies inside elements is sampled at several points of each") {
    const Mesh mesh = square_mesh(2);
    const FeMesh fe = straight_fe_mesh(mesh);
    ScalarProblem problem;
    problem.diffusion = [](Point p) { return square(1 + p.x); };
    const auto samples = scalar_flux(fe, problem, interpolant(fe, 1, [](Point p) { return p.y; }));
    REQUIRE(samples.points.size() > 8);
    for (std::size_t s = 0; s < samples.points.size(); ++s)
      CHECK(samples.values[2 * s + 1] == doctest::Approx(1 + samples.points[s].x));
  }

  TEST_CASE("samples lie at their reference points and their weights sum to the area") {
    const Mesh mesh = mixed_square(4, 3);
    const FeMesh fe = with_bent_bottom(mesh, 0.06);
    for (const int order : {1, 2}) {
      const FluxSamples samples = samples_of(fe, order, [](Index, Point) { return Vector{}; });
      CHECK(samples.degree == order);
      for (Index e = 0; e < fe.element_count(); ++e)
        for (Index s = samples.first[e]; s < samples.first[e + 1]; ++s)
          CHECK(map_at(element_at(fe, e), samples.at[s]).x == samples.points[s]);
      const double area = std::accumulate(samples.weights.begin(), samples.weights.end(), 0.);
      CHECK(area == doctest::Approx(1.04));
    }
  }

  TEST_CASE("the norm of the samples of a scalar solution is its energy") {
    const Mesh mesh = perturbed(mixed_square(5, 4), 5, 4, 0.2, 11);
    const FeMesh fe = straight_fe_mesh(mesh);
    ScalarProblem problem = dirichlet_problem(sine_product(3, 0), 3, 0);
    for (const int order : {1, 2}) {
      ScalarOptions options;
      options.order = order;
      const ScalarSolution solution = solve_scalar(fe, problem, options);
      const double norm = energy_of(scalar_flux(fe, problem, solution.field));
      // Quadrilaterals that are no parallelograms have rational stresses.
      CHECK(norm * norm == doctest::Approx(solution.squared_energy).epsilon(1e-3));
    }
  }

  TEST_CASE("the norm of the samples of a plate is twice its strain energy") {
    CHECK(energy_ratio(perturbed_mesh(4, 0.2, 3), PlateElement::mitc) ==
          doctest::Approx(1).epsilon(1e-3));
    CHECK(energy_ratio(mixed_square(4, 4), PlateElement::mitc) == doctest::Approx(1).epsilon(1e-3));
    CHECK(energy_ratio(square_quads(4, 4), PlateElement::mitc4) == doctest::Approx(1));
    CHECK(energy_ratio(square_mesh(4), PlateElement::arnold_falk) == doctest::Approx(1));
  }

  TEST_CASE("cylindrical bending of unit curvature has the energy density of its stiffness") {
    const Mesh mesh = square_quads(2, 2);
    const FeMesh fe = straight_fe_mesh(mesh);
    const PlateProblem problem = plate(unit_bending(0.1));
    PlateSolution solution;
    solution.dofs = make_dof_map(fe, plate_layout(PlateElement::mitc));
    // w = x^2 / 2, theta = (x, 0): M_xx = -1, M_yy = -0.3, no shear.
    const auto add = [&](Point p) {
      solution.values.insert(solution.values.end(), {0.5 * p.x * p.x, p.x, 0});
    };
    for (const Point& p : mesh.points) add(p);
    for (const Point& p : fe.edge_points) add(p);
    for (Index e = 0; e < 4; ++e) {
      const Point centre = map_at(element_at(fe, e), {0, 0}).x;
      solution.inner.insert(solution.inner.end(), {centre.x, 0});
    }
    const auto f = plate_flux_at(fe, problem, solution, element_at(fe, 2), {0.3, -0.6});
    REQUIRE(f.size() == 5);
    CHECK(f[0] * f[0] + f[1] * f[1] == doctest::Approx(1));
    CHECK(f[0] + f[1] == doctest::Approx(-1.3 / std::sqrt(1.3)));
    CHECK(f[2] == doctest::Approx(0).scale(1));
    CHECK(f[3] == doctest::Approx(0).scale(1));
    CHECK(f[4] == doctest::Approx(0).scale(1));
  }

  TEST_CASE("curves inside that carry a condition are marked as jumps") {
    const Mesh mesh = with_middle_curve(square_mesh(4), 0.5);
    const FeMesh fe = straight_fe_mesh(mesh);
    const auto field = interpolant(fe, 1, [](Point) { return 0.; });
    const auto marked = [&](const std::vector<char>& jumps) {
      return std::count(jumps.begin(), jumps.end(), 1);
    };
    ScalarProblem problem;
    CHECK(marked(scalar_flux(fe, problem, field).jumps) == 0);
    problem.fluxes.push_back({kMiddle, 1., 0.});
    CHECK(marked(scalar_flux(fe, problem, field).jumps) == 2);
    problem.dirichlet.push_back({kBottom, 0.});
    CHECK(marked(scalar_flux(fe, problem, field).jumps) == 6);
  }
}
