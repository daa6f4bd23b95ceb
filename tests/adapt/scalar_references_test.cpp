// The scalar references of FE.md 3.1 on meshes of the project's own mesher: triangles,
// quadrilaterals and both, stretched along layers and bent along curves.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "adapt/point_location.hpp"
#include "mesher/generate.hpp"
#include "solver/scalar/solve_scalar.hpp"
#include "tests/solver/disc_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

constexpr Elements kKinds[] = {Elements::triangle, Elements::quadrilateral, Elements::mixed};

Mesh generated(const Domain& domain, const Mesh& background, const MetricFunction& metric,
               Elements elements) {
  MetricField field;
  for (const Point p : background.points) field.push_back(metric(p));
  GenerateOptions options = generate_options(Preset::best);
  options.elements = elements;
  options.quads.effort = QuadEffort::fast;
  return generate(domain, background, field, options).mesh;
}

Domain square_domain() {
  Domain domain;
  const Point corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const char* names[] = {"bottom", "right", "top", "left"};
  for (Index k = 0; k < 4; ++k)
    domain.curves.push_back({names[k], k + 1, make_line(corners[k], corners[(k + 1) % 4])});
  add_region(domain, "square", 1, {0, 1, 2, 3}, {});
  return domain;
}

/// Sizes `least` at the sides, growing by 0.3 per length, in each direction by itself.
MetricFunction layer_metric(double least) {
  return [least](Point p) {
    const auto size = [least](double s) {
      return std::min(0.15, least + 0.3 * std::min(s, 1 - s));
    };
    const double hx = size(p.x), hy = size(p.y);
    return Metric{1 / (hx * hx), 0, 1 / (hy * hy)};
  };
}

ScalarOptions of_order(int order) {
  ScalarOptions options;
  options.order = order;
  options.threads = 1;
  return options;
}

}  // namespace

TEST_SUITE("convergence") {
  TEST_CASE("reaction-diffusion energies on meshes stretched along the layers") {
    const double epsilon = 0.01, energy = 0.960509295817894;
    const Mesh background = mapped(square_mesh(40), [](Point p) {
      return Point{sinh_grading(p.x, 3), sinh_grading(p.y, 3)};
    });
    ScalarProblem problem{epsilon * epsilon, 1., 1.};
    for (const Index side : {kBottom, kRight, kTop, kLeft}) problem.dirichlet.push_back({side, 0});
    for (const Elements elements : kKinds) {
      const Mesh mesh = generated(square_domain(), background, layer_metric(0.005), elements);
      CAPTURE(mesh.triangles.size());
      CAPTURE(mesh.quads.size());
      CHECK(mesh.points.size() < 4000);
      const FeMesh fe = straight_fe_mesh(mesh);
      const double linear = energy - solve_scalar(fe, problem, of_order(1)).squared_energy;
      const double quadratic = energy - solve_scalar(fe, problem, of_order(2)).squared_energy;
      // The energy norm of the error is the root of these.
      CHECK(linear > 0);
      CHECK(linear < 2e-3);
      CHECK(quadratic > 0);
      CHECK(quadratic < 1e-4);
    }
  }

  TEST_CASE("the disc under a uniform load on meshes with bent edges") {
    // u = (1 - r^2) / 4: u(0) = 1/4 and int |grad u|^2 = pi / 8.
    const Domain domain = disc_domain();
    Mesh box;
    box.points = {{-1.1, -1.1}, {1.1, -1.1}, {1.1, 1.1}, {-1.1, 1.1}};
    box.triangles = {{0, 1, 2}, {0, 2, 3}};
    box.triangle_regions = {1, 1};
    const ScalarProblem problem{1., 0., 1., {{kRim, 0}}};
    for (const Elements elements : kKinds) {
      const Mesh mesh = generated(
          domain, box, [](Point) { return metric_from_size(0.1); }, elements);
      const FeMesh bent = curved_fe_mesh(mesh, domain), straight = straight_fe_mesh(mesh);
      const ScalarField u = solve_scalar(bent, problem, of_order(2)).field;
      CHECK(squared_energy(bent, problem, u) ==
            doctest::Approx(std::numbers::pi / 8).epsilon(2e-6));
      const Location centre = PointLocation(bent).nearest({0, 0});
      CHECK(scalar_state(bent, u, centre.element, centre.at).value ==
            doctest::Approx(0.25).epsilon(2e-6));
      // The polygon lacks a share of the area of the size of h^2.
      const double chords = solve_scalar(straight, problem, of_order(2)).squared_energy;
      CHECK(chords < 0.998 * std::numbers::pi / 8);
    }
  }
}
