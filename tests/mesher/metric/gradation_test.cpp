#include "mesher/metric/gradation.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/topology.hpp"
#include "tests/mesher/metric/random_metric.hpp"

using namespace anisofront;
using doctest::Approx;

namespace {

/// n x n squares on [0, 1]^2, two triangles each.
Mesh grid(Index n) {
  Mesh mesh;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) mesh.points.push_back({1. * i / n, 1. * j / n});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      mesh.triangles.push_back({a, a + 1, a + n + 2});
      mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  return mesh;
}

/// Largest v'M1 v / v'M2 v, sampled: the excess of m1 over m2.
double excess(const Metric& m1, const Metric& m2) {
  double largest = 0;
  const PrincipalAxes axes[] = {principal_axes(m1), principal_axes(m2)};
  for (int k = 0; k < 36; ++k) {
    const double phi = 0.0873 * k;
    const Vector v =
        k < 4 ? (k % 2 ? axes[k / 2].e1 : axes[k / 2].e2) : Vector{std::cos(phi), std::sin(phi)};
    largest = std::max(largest, squared_length(m1, v) / squared_length(m2, v));
  }
  return largest;
}

/// Largest excess over all edges of what one end allows over what the other end has; the formula
/// of the header.
double worst_edge(const Mesh& mesh, const MetricField& field, double ratio) {
  double worst = 0;
  const auto visit = [&](Index p, Index q) {
    const double l = length(field[p], mesh.points[q] - mesh.points[p]);
    const double growth = 1 + l * std::log(ratio);
    worst = std::max(worst, excess(scaled(field[p], 1 / (growth * growth)), field[q]));
  };
  for (const auto& [a, b] : mesh_edges(mesh)) {
    visit(a, b);
    visit(b, a);
  }
  return worst;
}

MetricField random_field(const Mesh& mesh, double max_stretch, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  MetricField field;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    field.push_back(random_metric(random, max_stretch));
  return field;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("isotropic sizes grow linearly with the distance from the fine place") {
    const Mesh mesh = grid(10);
    MetricField field(mesh.points.size(), metric_from_size(100));
    field[0] = metric_from_size(0.1);
    limit_gradation(mesh, field, 2);
    for (Index i = 0; i <= 10; ++i) {  // h0 + distance ln 2, along the bottom edge
      const double h = principal_axes(field[i]).h1;
      CHECK(h == Approx(0.1 + 0.1 * i * 0.69314718056).epsilon(2e-3));
    }
    const double far = principal_axes(field.back()).h1;  // along the diagonal edges
    CHECK(far == Approx(0.1 + std::sqrt(2.) * 0.69314718056).epsilon(2e-3));
  }

  TEST_CASE("the ratio bounds the growth over a unit of length") {
    const Mesh mesh = grid(20);
    MetricField field(mesh.points.size(), metric_from_size(5));
    field[0] = metric_from_size(0.02);
    limit_gradation(mesh, field, 1.5);
    for (const auto& [a, b] : mesh_edges(mesh)) {
      double h1 = principal_axes(field[a]).h1, h2 = principal_axes(field[b]).h1;
      if (h1 > h2) std::swap(h1, h2);
      const double l = norm(mesh.points[b] - mesh.points[a]) * std::log(h2 / h1) / (h2 - h1);
      if (h2 > h1 * 1.001) CHECK(std::pow(h2 / h1, 1 / l) <= 1.5 * 1.001);  // h-shock
    }
  }

  TEST_CASE("anisotropic sizes keep the stretch of the fine place") {
    const Mesh mesh = grid(4);
    MetricField field(mesh.points.size(), metric_from_size(1000));
    field[12] = metric_from_sizes(0.01, 0.5, {0, 1});  // the centre
    limit_gradation(mesh, field, 2);
    const PrincipalAxes next = principal_axes(field[13]);  // length 0.25 / 0.5 along x
    const double growth = 1 + 0.5 * 0.69314718056;
    CHECK(next.h1 == Approx(0.01 * growth).epsilon(2e-3));
    CHECK(next.h2 == Approx(0.5 * growth).epsilon(2e-3));
    CHECK(std::fabs(next.e1.y) == Approx(1).epsilon(1e-6));
  }

  TEST_CASE("a uniform field and a ratio of at most one change nothing") {
    const Mesh mesh = grid(5);
    MetricField uniform(mesh.points.size(), Metric{5, 2, 3});
    limit_gradation(mesh, uniform, 1.1);
    CHECK(uniform == MetricField(mesh.points.size(), Metric{5, 2, 3}));
    const MetricField rough = random_field(mesh, 100, 1);
    for (const double ratio : {1., 0.5, 0., -3., std::nan("")}) {
      MetricField field = rough;
      limit_gradation(mesh, field, ratio);
      CHECK(field == rough);
    }
  }

  TEST_CASE("a field of the wrong size is refused") {
    MetricField field(3);
    CHECK_THROWS_WITH_AS(limit_gradation(grid(1), field, 2),
                         doctest::Contains("3 entries, expected one per vertex: 4"), InputError);
  }
}

TEST_SUITE("property") {
  TEST_CASE("afterwards every edge obeys the ratio and no size has grown") {
    const Mesh mesh = grid(12);
    for (const double max_stretch : {1., 10., 1000.})
      for (const double ratio : {1.05, 1.5, 3.}) {
        CAPTURE(max_stretch);
        CAPTURE(ratio);
        const MetricField before = random_field(mesh, max_stretch, 71);
        MetricField field = before;
        limit_gradation(mesh, field, ratio);
        CHECK(worst_edge(mesh, field, ratio) <= 1.002);
        CHECK(worst_edge(mesh, before, ratio) > 100);
        double coarsening = 0;
        for (std::size_t v = 0; v < field.size(); ++v) {
          CHECK(is_positive_definite(field[v]));
          coarsening = std::max(coarsening, excess(before[v], field[v]));
        }
        CHECK(coarsening <= 1 + 1e-7);
        MetricField again = field;
        limit_gradation(mesh, again, ratio);
        CHECK(again == field);
      }
  }
}
