#include "adapt/error_metric.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

constexpr double kNone = 0;

std::vector<LocalQuadratic> with_hessians(std::vector<Hessian> hessians) {
  std::vector<LocalQuadratic> quadratics;
  for (const Hessian& h : hessians) quadratics.push_back({{}, h});
  return quadratics;
}

/// |H| of a function with layers of width 0.05 at x = 0 and along y = 0, at the vertices.
PrincipalField layer_density(const Mesh& mesh, AdaptMode mode) {
  std::vector<Hessian> hessians;
  for (const Point& p : mesh.points)
    hessians.push_back({400 * std::exp(-p.x / 0.05) + 0.1, 0.3, 400 * std::exp(-p.y / 0.05)});
  return lp_density(absolute_hessians(with_hessians(hessians), mode, 1e-6), 2);
}

/// Eigenvalues of a metric by the characteristic polynomial, the larger first.
std::array<double, 2> eigenvalues(const Metric& m) {
  const double mean = 0.5 * (m.m11 + m.m22);
  const double radius = std::sqrt(mean * mean - determinant(m));
  return {mean + radius, mean - radius};
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the absolute Hessian has the moduli of the eigenvalues and the same eigenvectors") {
    // Eigenvalues 5 along (1, 2)/sqrt5 and -10 along (2, -1)/sqrt5.
    const auto field =
        absolute_hessians(with_hessians({{-7, 6, 2}}), AdaptMode::anisotropic, kNone);
    CHECK(field[0].l1 == doctest::Approx(10));
    CHECK(field[0].l2 == doctest::Approx(5));
    const Metric m = metric_of(field[0]);
    CHECK(m.m11 == doctest::Approx(9));
    CHECK(m.m12 == doctest::Approx(-2));
    CHECK(m.m22 == doctest::Approx(6));
  }

  TEST_CASE("isotropic mode takes the larger modulus in both directions") {
    const auto field = absolute_hessians(with_hessians({{-7, 6, 2}}), AdaptMode::isotropic, kNone);
    CHECK(metric_of(field[0]).m11 == doctest::Approx(10));
    CHECK(metric_of(field[0]).m12 == 0);
    CHECK(metric_of(field[0]).m22 == doctest::Approx(10));
  }

  TEST_CASE("curvatures below the floor are lifted and a flat function gives the unit metric") {
    const auto lifted = absolute_hessians(with_hessians({{100, 0, 0}, {0, 0, -0.001}}),
                                          AdaptMode::anisotropic, 0.01);
    CHECK(lifted[0].l1 == doctest::Approx(100));
    CHECK(lifted[0].l2 == doctest::Approx(1));
    CHECK(lifted[1].l1 == doctest::Approx(1));
    CHECK(lifted[1].l2 == doctest::Approx(1));
    const auto flat = absolute_hessians(with_hessians({{}, {}}), AdaptMode::anisotropic, 0.01);
    CHECK(flat[1].l1 == 1);
    CHECK(flat[1].l2 == 1);
  }

  TEST_CASE("the L2 density is the absolute Hessian by the sixth root of its determinant") {
    const PrincipalField density = lp_density({{16, 4, {0, 1}}}, 2);
    CHECK(density[0].l1 == doctest::Approx(8));  // 64^(-1/6) = 1/2
    CHECK(density[0].l2 == doctest::Approx(2));
    CHECK(lp_density({{16, 4, {0, 1}}}, 1)[0].l2 == doctest::Approx(std::sqrt(2)));  // 64^(-1/4)
  }

  TEST_CASE("limits clip sizes and let the larger size give way to the stretch") {
    const MetricLimits limits{.hmin = 0.01, .hmax = 2, .stretch = 10};
    const PrincipalMetric m = limited({1e6, 1e-3, {0, 1}}, limits);
    CHECK(m.l1 == doctest::Approx(1e4));
    CHECK(m.l2 == doctest::Approx(100));
    const PrincipalMetric coarse = limited({1e-3, 1e-4, {0, 1}}, limits);
    CHECK(coarse.l1 == doctest::Approx(0.25));
    CHECK(coarse.l2 == doctest::Approx(0.25));
    CHECK(limited({1e6, 1e-3, {0, 1}}, {}).l2 == 1e-3);
  }

  TEST_CASE(
      "a uniform metric of size h on the unit square has complexity and vertices of its grid") {
    const Mesh mesh = square_mesh(3);
    const MetricField field(mesh.points.size(), Metric{100, 0, 100});
    CHECK(complexity(mesh, field) == doctest::Approx(100));
    // 40 boundary edges of length 0.1, 400 / sqrt 3 equilateral triangles.
    CHECK(expected_vertices(mesh, field) == doctest::Approx(1 + 200 / std::sqrt(3.) + 20));
  }

  TEST_CASE("targets that are no numbers and limits that contradict each other are refused") {
    const Mesh mesh = square_mesh(4);
    const PrincipalField density(mesh.points.size());
    const auto scale = [&](double target, const MetricLimits& limits) {
      return scale_metric(mesh, density, complexity, target, limits);
    };
    CHECK_THROWS_AS(scale(0, {}), InputError);
    CHECK_THROWS_AS(scale(std::nan(""), {}), InputError);
    CHECK_THROWS_WITH_AS(scale(10, {.hmin = 1, .hmax = 0.5}), doctest::Contains("hmin < hmax"),
                         InputError);
    CHECK_THROWS_AS(scale(10, {.stretch = 0.5}), InputError);
  }
}

TEST_SUITE("property") {
  TEST_CASE("the scaled metric has the target complexity after all limits") {
    const Mesh mesh = perturbed_mesh(20, 0.3, 5);
    for (const AdaptMode mode : {AdaptMode::anisotropic, AdaptMode::isotropic})
      for (const double target : {50., 1000., 2e5})
        for (const MetricLimits& limits :
             {MetricLimits{}, MetricLimits{.hmin = 1e-3, .hmax = 0.3},
              MetricLimits{.hmin = 1e-4, .hmax = 0.5, .stretch = 5, .gradation = 2}}) {
          const auto [field, measure] =
              scale_metric(mesh, layer_density(mesh, mode), complexity, target, limits);
          CAPTURE(target);
          CAPTURE(limits.stretch);
          CHECK(complexity(mesh, field) == doctest::Approx(target).epsilon(1e-3));
          CHECK(measure == doctest::Approx(target).epsilon(1e-3));
        }
  }

  TEST_CASE("without gradation every scaled metric obeys sizes and stretch") {
    const Mesh mesh = square_mesh(20);
    const MetricLimits limits{.hmin = 0.01, .hmax = 0.2, .stretch = 4};
    const auto [field, measure] = scale_metric(mesh, layer_density(mesh, AdaptMode::anisotropic),
                                               expected_vertices, 800, limits);
    CHECK(measure == doctest::Approx(800).epsilon(1e-3));
    for (const Metric& m : field) {
      const auto [l1, l2] = eigenvalues(m);
      CHECK(l1 <= 1e4 * (1 + 1e-12));
      CHECK(l2 >= 25 * (1 - 1e-12));
      CHECK(l1 <= 16 * l2 * (1 + 1e-9));
    }
  }

  TEST_CASE("a target that the limits forbid gives the nearest mesh and says so") {
    const Mesh mesh = square_mesh(10);
    const PrincipalField density = layer_density(mesh, AdaptMode::anisotropic);
    CHECK(scale_metric(mesh, density, complexity, 1e6, {.hmin = 0.1}).measure ==
          doctest::Approx(100).epsilon(1e-6));
    CHECK(scale_metric(mesh, density, complexity, 1, {.hmax = 0.2}).measure ==
          doctest::Approx(25).epsilon(1e-6));
  }

  TEST_CASE("without limits the metrics of two targets differ by one factor") {
    const Mesh mesh = square_mesh(12);
    const PrincipalField density = layer_density(mesh, AdaptMode::anisotropic);
    const auto small = scale_metric(mesh, density, complexity, 100, {}).field;
    const auto large = scale_metric(mesh, density, complexity, 700, {}).field;
    for (std::size_t v = 0; v < small.size(); ++v) {
      CHECK(large[v].m11 == doctest::Approx(7 * small[v].m11).epsilon(1e-3));
      CHECK(large[v].m22 == doctest::Approx(7 * small[v].m22).epsilon(1e-3));
    }
  }
}
