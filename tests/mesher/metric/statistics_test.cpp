#include "mesher/metric/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/topology.hpp"
#include "mesher/metric/metric_length.hpp"
#include "mesher/metric/quality.hpp"
#include "tests/mesher/metric/random_metric.hpp"

using namespace anisofront;
using doctest::Approx;

namespace {

const double kSqrt3 = std::sqrt(3.);

/// Rows of equilateral triangles of side 1: a parallelogram of n x n rhombi.
Mesh equilateral_mesh(Index n) {
  Mesh mesh;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) mesh.points.push_back({i + 0.5 * j, 0.5 * kSqrt3 * j});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      mesh.triangles.push_back({a, a + 1, a + n + 1});
      mesh.triangles.push_back({a + 1, a + n + 2, a + n + 1});
    }
  return mesh;
}

/// One unit square of quads beside one of triangles.
Mesh mixed_mesh() {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}};
  mesh.triangles = {{0, 1, 4}, {0, 4, 3}};
  mesh.quads = {{1, 2, 5, 4}};
  return mesh;
}

Metric isotropic(Point p) { return metric_from_size(0.5 + 0.25 * p.x); }

std::int64_t total(const MeshStatistics& s) {
  return std::accumulate(s.histogram.begin(), s.histogram.end(), std::int64_t{0});
}

MetricField sample(const Mesh& mesh, const MetricFunction& metric) {
  MetricField field;
  for (const Point p : mesh.points) field.push_back(metric(p));
  return field;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a mesh of unit equilateral triangles is perfect") {
    const Mesh mesh = equilateral_mesh(6);
    const MeshStatistics s = mesh_statistics(mesh, [](Point) { return Metric{}; });
    CHECK(s.vertices == 49);
    CHECK(s.elements == 72);
    CHECK(s.triangles == 72);
    CHECK(s.quads == 0);
    CHECK(s.edges == 120);  // V - E + F = 1
    CHECK(s.boundary_edges == 24);
    CHECK(s.quality_mean == Approx(1).epsilon(1e-14));
    CHECK(s.quality_min == Approx(1).epsilon(1e-14));
    CHECK(s.length_min == Approx(1).epsilon(1e-14));
    CHECK(s.length_max == Approx(1).epsilon(1e-14));
    CHECK(s.percent_half == 100);
    CHECK(s.percent_unit == 100);
    CHECK(s.angle_min == Approx(60).epsilon(1e-13));
    CHECK(s.angle_max == Approx(60).epsilon(1e-13));
    CHECK(s.stretch_max == 1);
    CHECK(s.scaled_jacobian_min == 1);
    CHECK(s.complexity == Approx(36 * 0.5 * kSqrt3).epsilon(1e-14));
    CHECK(s.histogram[10] == 120);  // [1.0, 1.1)
    CHECK(metric_complexity(mesh, MetricField(49)) == Approx(72).epsilon(1e-14));
  }

  TEST_CASE("figures of a mixed mesh by hand") {
    const Mesh mesh = mixed_mesh();
    const MeshStatistics s = mesh_statistics(mesh, MetricField(6));
    CHECK(s.elements == 3);
    CHECK(s.edges == 8);
    CHECK(s.boundary_edges == 6);
    CHECK(s.quality_mean == Approx(std::cbrt(0.75)).epsilon(1e-14));  // (sqrt 3 / 2)^2 * 1
    CHECK(s.quality_min == Approx(kSqrt3 / 2).epsilon(1e-14));
    CHECK(s.length_min == Approx(1).epsilon(1e-14));
    CHECK(s.length_max == Approx(std::sqrt(2.)).epsilon(1e-14));
    CHECK(s.percent_unit == 100);  // sqrt 2 itself is inside
    CHECK(s.angle_min == Approx(45).epsilon(1e-13));
    CHECK(s.angle_max == Approx(90).epsilon(1e-13));
    CHECK(s.complexity == Approx(2).epsilon(1e-14));
    CHECK(s.histogram[10] == 7);
    CHECK(s.histogram[14] == 1);
    CHECK(total(s) == 8);
  }

  TEST_CASE("a finer metric lengthens the edges") {
    // lengths 1.6 (7 of them) and 2.26: outside both bands, angles and shapes unchanged
    const MeshStatistics s = mesh_statistics(mixed_mesh(), MetricField(6, metric_from_size(0.625)));
    CHECK(s.percent_half == 0);
    CHECK(s.percent_unit == 0);
    CHECK(s.histogram[16] == 7);
    CHECK(s.histogram[22] == 1);
    CHECK(s.complexity == Approx(2 / 0.390625).epsilon(1e-14));
    CHECK(s.quality_min == Approx(kSqrt3 / 2).epsilon(1e-14));
  }

  TEST_CASE("lengths beyond three fall into the last bin") {
    const MeshStatistics s = mesh_statistics(mixed_mesh(), MetricField(6, metric_from_size(0.01)));
    CHECK(s.histogram[kLengthBins - 1] == 8);
    CHECK(s.length_max == Approx(100 * std::sqrt(2.)).epsilon(1e-13));
  }

  TEST_CASE("stretch and metric angles of an anisotropic metric") {
    // size 1/kSqrt3 along y: the diagonal of the unit square makes 60 and 30 degrees
    const MeshStatistics s = mesh_statistics(mixed_mesh(), MetricField(6, {1, 0, 3}));
    CHECK(s.stretch_max == Approx(kSqrt3).epsilon(1e-14));
    CHECK(s.angle_min == Approx(30).epsilon(1e-13));
    CHECK(s.angle_max == Approx(90).epsilon(1e-13));
    CHECK(s.length_max == Approx(2).epsilon(1e-14));
  }

  TEST_CASE("the scaled Jacobian is that of the worst corner in physical space") {
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0}, {1.5, kSqrt3 / 2}, {0.5, kSqrt3 / 2}};
    mesh.quads = {{0, 1, 2, 3}};
    const MeshStatistics s = mesh_statistics(mesh, MetricField(4, {1, 0, 100}));
    CHECK(s.scaled_jacobian_min == Approx(kSqrt3 / 2).epsilon(1e-14));
  }

  TEST_CASE("qualities and scaled Jacobians per element by hand") {
    // A unit square, a parallelogram of 45 degrees and height 1, half a square.
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {0, 2}};
    mesh.quads = {{0, 1, 2, 3}, {1, 4, 2, 0}};
    mesh.quads[1] = {0, 1, 4, 2};
    mesh.triangles = {{3, 2, 5}};
    const std::vector<double> jacobians = scaled_jacobians(mesh);
    REQUIRE(jacobians.size() == 3);
    CHECK(jacobians[0] == 1);  // triangles come first
    CHECK(jacobians[1] == doctest::Approx(1));
    CHECK(jacobians[2] == doctest::Approx(std::sqrt(0.5)));
    const std::vector<double> quality = element_qualities(mesh, MetricField(6));
    REQUIRE(quality.size() == 3);
    CHECK(quality[0] == doctest::Approx(std::sqrt(3) / 2));  // 2 sqrt3 A 2 / (1 + 1 + 2)
    CHECK(quality[1] == doctest::Approx(1));
    // Halves of the parallelogram: squares of sides 1 + 2 + 1 and 1 + 2 + 5, twice each.
    CHECK(quality[2] == doctest::Approx(0.25));
    CHECK_THROWS_AS(element_qualities(mesh, MetricField(5)), InputError);
  }

  TEST_CASE("the qualities are counted in twenty bins") {
    const auto counts = [](const Mesh& mesh, const MetricField& field) {
      return mesh_statistics(mesh, field).quality_histogram;
    };
    std::array<std::int64_t, kQualityBins> expected{};
    expected[17] = 2;  // sqrt 3 / 2 = 0.866
    expected[19] = 1;  // 1 itself
    CHECK(counts(mixed_mesh(), MetricField(6)) == expected);
    // By hand as above: halves of a parallelogram of quality 1/4, which is a bound.
    Mesh sheared;
    sheared.points = {{0, 0}, {1, 0}, {2, 1}, {1, 1}};
    sheared.quads = {{0, 1, 2, 3}};
    expected = {};
    expected[5] = 1;  // [0.25, 0.3)
    CHECK(counts(sheared, MetricField(4)) == expected);
    Mesh inverted = mixed_mesh();
    inverted.points[4] = {1, -0.5};
    CHECK(counts(inverted, MetricField(6))[0] == 2);  // the quad and the triangle below it
    CHECK(counts(Mesh{}, {}) == std::array<std::int64_t, kQualityBins>{});
  }

  TEST_CASE("an element without an area has quality zero") {
    Mesh flat;
    flat.points = {{0, 0}, {1, 0}, {2, 0}, {1, 1}, {1, 1}};
    flat.triangles = {{0, 1, 2}, {3, 3, 3}};  // 3, 3, 3: zero by zero
    CHECK(mesh_statistics(flat, MetricField(5)).quality_histogram[0] == 2);
  }

  TEST_CASE("lengths of the edges of a mixed mesh by hand") {
    const auto wide = [](Point) { return Metric{4, 0, 1}; };  // x counts twice
    const std::vector<double> lengths = edge_lengths(mixed_mesh(), wide);
    // Edges of 0 1 4 and 0 4 3 opposite their vertices, then 1-2, 2-5 and 5-4.
    const double diagonal = std::sqrt(5.);
    const std::vector<double> expected{1, diagonal, 2, 2, 1, 2, 1, 2};
    REQUIRE(lengths.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      CHECK(lengths[i] == Approx(expected[i]).epsilon(1e-14));
    CHECK(edge_lengths(Mesh{}, wide).empty());
  }

  TEST_CASE("an inverted element shows as quality and mean") {
    Mesh mesh = mixed_mesh();
    mesh.points[4] = {1, -0.5};
    const MeshStatistics s = mesh_statistics(mesh, MetricField(6));
    CHECK(s.quality_min == -1);  // the quad
    CHECK(s.quality_mean == 0);
    CHECK(s.angle_max > 180);
  }

  TEST_CASE("an empty mesh has zero statistics and a short field is refused") {
    CHECK(mesh_statistics(Mesh{}, MetricField{}).edges == 0);
    CHECK(metric_complexity(Mesh{}, {}) == 0);
    CHECK_THROWS_AS(mesh_statistics(mixed_mesh(), MetricField(5)), InputError);
    CHECK_THROWS_AS(metric_complexity(mixed_mesh(), MetricField(7)), InputError);
  }

  TEST_CASE("a linear isotropic size gives the same figures as function and as field") {
    const Mesh mesh = mixed_mesh();
    const MeshStatistics f = mesh_statistics(mesh, isotropic);
    const MeshStatistics g = mesh_statistics(mesh, sample(mesh, isotropic));
    CHECK(g.length_min == Approx(f.length_min).epsilon(1e-13));
    CHECK(g.length_max == Approx(f.length_max).epsilon(1e-13));
    CHECK(g.quality_mean == Approx(f.quality_mean).epsilon(1e-13));
    CHECK(g.complexity == Approx(f.complexity).epsilon(1e-13));
    // the shortest edge is the right side, x = 2 and h = 1; bottom left: 4 ln(1.5)
    CHECK(f.length_min == Approx(1).epsilon(1e-13));
    CHECK(segment_length(isotropic, {0, 0}, {1, 0}, 0.1) ==
          Approx(4 * std::log(1.5)).epsilon(1e-3));
    CHECK(f.length_max == Approx(4 * std::sqrt(2.) * std::log(1.5)).epsilon(1e-3));
  }

  TEST_CASE("complexity converges to the integral") {
    // integral of 1/h^2 over the parallelogram strip x in [0,4]: h = 0.5 + x/4, height 1
    Mesh mesh;
    const Index n = 64;
    for (Index i = 0; i <= n; ++i) {
      mesh.points.push_back({4. * i / n, 0});
      mesh.points.push_back({4. * i / n, 1});
    }
    for (Index i = 0; i < n / 2; ++i) {
      const Index a = 2 * i;
      mesh.triangles.push_back({a, a + 2, a + 3});
      mesh.triangles.push_back({a, a + 3, a + 1});
    }
    for (Index i = n / 2; i < n; ++i)
      mesh.quads.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    const double exact = 4 * (1 / 0.5 - 1 / 1.5);  // by hand: 16/3
    CHECK(mesh_statistics(mesh, isotropic).complexity == Approx(exact).epsilon(1e-4));
    CHECK(metric_complexity(mesh, sample(mesh, isotropic)) ==
          Approx(4 / kSqrt3 * exact).epsilon(1e-4));
  }
}

TEST_SUITE("property") {
  TEST_CASE("statistics agree with the definitions element by element") {
    const auto metric = [](Point p) {
      return metric_from_sizes(0.4 + 0.1 * p.x, 1 + 0.2 * p.y, {1, p.x - p.y});
    };
    const Mesh mesh = equilateral_mesh(5);
    const MeshStatistics s = mesh_statistics(mesh, metric);
    double product = 1, least = 1, shortest = 1e9, longest = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::array p{mesh.points[a], mesh.points[b], mesh.points[c]};
      const double quality = alpha(std::array{metric(p[0]), metric(p[1]), metric(p[2])}, p);
      product *= quality;
      least = std::min(least, quality);
      for (std::size_t k = 0; k < 3; ++k) {
        const double l = segment_length(metric, p[k], p[(k + 1) % 3], 0.1);
        shortest = std::min(shortest, l);
        longest = std::max(longest, l);
      }
    }
    CHECK(s.quality_mean == Approx(std::pow(product, 1. / s.triangles)).epsilon(1e-12));
    CHECK(s.quality_min == Approx(least).epsilon(1e-13));
    CHECK(s.length_min == Approx(shortest).epsilon(1e-12));
    CHECK(s.length_max == Approx(longest).epsilon(1e-12));
    CHECK(total(s) == s.edges);
  }

  TEST_CASE("edge lengths are those that the statistics count") {
    const auto metric = [](Point p) {
      return metric_from_sizes(0.3 + 0.1 * p.x, 1 + 0.2 * p.y, {1, p.x - p.y});
    };
    Mesh mesh = equilateral_mesh(5);
    mesh.points.push_back({2.5, 6});
    mesh.points.push_back({3.5, 6});
    mesh.quads = {{30, 31, 37, 36}};  // on the upper side
    const std::vector<double> lengths = edge_lengths(mesh, metric);
    const std::vector<std::array<Index, 2>> edges = mesh_edges(mesh);
    REQUIRE(lengths.size() == edges.size());
    const MeshStatistics s = mesh_statistics(mesh, metric);
    CHECK(s.length_min == *std::min_element(lengths.begin(), lengths.end()));
    CHECK(s.length_max == *std::max_element(lengths.begin(), lengths.end()));
    std::array<std::int64_t, kLengthBins> counts{};
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto [a, b] = edges[e];
      CHECK(lengths[e] ==
            Approx(segment_length(metric, mesh.points[a], mesh.points[b], 0.1)).epsilon(1e-12));
      ++counts[std::min<std::size_t>(static_cast<std::size_t>(10 * lengths[e]), kLengthBins - 1)];
    }
    CHECK(counts == s.histogram);
  }

  TEST_CASE("along an edge of a field the size tensor is linear") {
    std::mt19937_64 random(81);
    for (int i = 0; i < 200; ++i) {
      Mesh mesh;
      mesh.points = {{0, 0}, {1, 0}, {0.5, 1e-3}};
      mesh.triangles = {{0, 1, 2}};
      const Metric m1 = random_metric(random, 100), m2 = random_metric(random, 100);
      const auto between = [&](Point p) {
        const SizeTensor a = size_of(m1), b = size_of(m2);
        return metric_of(SizeTensor{a.h11 + p.x * (b.h11 - a.h11), a.h12 + p.x * (b.h12 - a.h12),
                                    a.h22 + p.x * (b.h22 - a.h22)});
      };
      const double expected = segment_length(between, {0, 0}, {1, 0}, 0.1);
      const MeshStatistics s = mesh_statistics(mesh, MetricField{m1, m2, between({0.5, 0})});
      // the two other edges are nearly halves of the first in nearly the same metric
      CHECK(s.length_max >= expected * (1 - 1e-9));
      CHECK(s.length_min <= expected);
    }
  }
}
