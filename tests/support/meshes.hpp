#pragma once

// Meshes and metrics that several tests start from.
#include <cmath>
#include <random>
#include <vector>

#include "mesher/mesh/mesh.hpp"
#include "mesher/metric/intersection.hpp"
#include "mesher/metric/metric_field.hpp"

namespace anisofront::testing {

inline MetricField sample(const Mesh& mesh, const MetricFunction& metric) {
  MetricField field;
  for (const Point p : mesh.points) field.push_back(metric(p));
  return field;
}

/// n x m rectangles with both diagonals: 4 n m triangles, region tag 5, no curve edges.
inline Mesh crossed_rectangle(Index n, Index m, Point low, Point high) {
  Mesh mesh;
  const auto at = [&](double i, double j) {
    return Point{std::lerp(low.x, high.x, i / n), std::lerp(low.y, high.y, j / m)};
  };
  for (Index j = 0; j <= m; ++j)
    for (Index i = 0; i <= n; ++i) mesh.points.push_back(at(i, j));
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < n; ++i) {
      const auto c = static_cast<Index>(mesh.points.size());
      mesh.points.push_back(at(i + 0.5, j + 0.5));
      const Index a = j * (n + 1) + i, b = a + 1, d = a + n + 1, e = d + 1;
      for (const Triangle& t : {Triangle{a, b, c}, {b, e, c}, {e, d, c}, {d, a, c}})
        mesh.triangles.push_back(t);
    }
  mesh.triangle_regions.assign(mesh.triangles.size(), 5);
  return mesh;
}

/// n x n crossed squares on [0, side]^2. Its edges lie on curves 0 to 3 of square_domain(side) with
/// tags 1 to 4. For n = 2 and side 10 this is the start mesh of the paper's Examples 1 and 2.
inline Mesh crossed_square(Index n, double side) {
  Mesh mesh = crossed_rectangle(n, n, {0, 0}, {side, side});
  const Index w = n + 1;
  const auto add = [&](Index a, Index b, Index curve, Index i) {
    mesh.edges.push_back({{a, b}, curve + 1, curve, {1. * i / n, 1. * (i + 1) / n}});
  };
  for (Index i = 0; i < n; ++i) {
    add(i, i + 1, 0, i);
    add(i * w + n, (i + 1) * w + n, 1, i);
    add(n * w + n - i, n * w + n - i - 1, 2, i);
    add((n - i) * w, (n - i - 1) * w, 3, i);
  }
  return mesh;
}

/// Example 1: thin along the line x = y (M1) or x + y = 10 (M2), or both (EXAMPLES.md, 1).
inline Metric example_1_line(double r, Vector normal) {
  const double h1 = 0.05 + 0.15 * r;
  return metric_from_sizes(h1, 15 * h1 * std::exp(-0.55 * r), normal);
}
inline Metric example_1_m1(Point p) {
  return example_1_line(std::fabs(p.x - p.y) / std::sqrt(2.), {-1, 1});
}
inline Metric example_1_m2(Point p) {
  return example_1_line(std::fabs(p.x + p.y - 10) / std::sqrt(2.), {1, 1});
}
inline Metric example_1(Point p) { return intersect(example_1_m1(p), example_1_m2(p)); }

/// Example 2: boundary layers along the axes (EXAMPLES.md, 2).
inline Metric example_2_isotropic(Point p) {
  return metric_from_size(0.05 + 0.2 * std::pow(std::min(p.x, p.y), 1.25));
}
inline Metric example_2_anisotropic(Point p) {
  const double hy = 0.05 + 0.2 * std::pow(p.y, 1.25), hx = 0.05 + 0.2 * std::pow(p.x, 1.25);
  const double rate = std::log(8.) / 10;
  return metric_from_sizes(std::min(8 * hy * std::exp(-rate * p.y), hx),
                           std::min(hy, 8 * hx * std::exp(-rate * p.x)), {1, 0});
}

/// Metrics drawn anew at every point: directions uniform, stretch up to `max_stretch`, mean size
/// within a factor of two of h, area of the unit ellipse near that of size h.
struct RandomMetric {
  std::mt19937_64* random;
  double h = 1;
  double max_stretch = 1000;

  Metric operator()(Point) const {
    std::uniform_real_distribution<double> unit(0, 1);
    const double phi = 3.141592653589793 * unit(*random);
    const double root = std::pow(max_stretch, 0.5 * unit(*random));
    const double size = h * std::pow(2, 2 * unit(*random) - 1);
    return metric_from_sizes(size / root, size * root, {std::cos(phi), std::sin(phi)});
  }
};

/// A smooth random metric: size, stretch and direction are waves.
inline MetricFunction smooth_random_metric(std::mt19937_64& random, double h, double max_stretch,
                                           double wave_length) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double k = 6.283185307179586 / wave_length;
  const double a = 6.283185307179586 * unit(random), b = 6.283185307179586 * unit(random);
  const double root = std::pow(max_stretch, 0.5 * unit(random));
  return [=](Point p) {
    const double size = h * std::exp2(std::sin(k * p.x + a));
    const double s = std::pow(root, 0.5 + 0.5 * std::cos(k * p.y + b));
    const double phi = 3 * std::sin(0.5 * k * (p.x + p.y) + a - b);
    return metric_from_sizes(size / s, size * s, {std::cos(phi), std::sin(phi)});
  };
}

}  // namespace anisofront::testing
