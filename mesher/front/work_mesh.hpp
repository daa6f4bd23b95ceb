#pragma once

#include <array>
#include <vector>

#include "mesher/geometry/point.hpp"
#include "mesher/metric/metric.hpp"
#include "mesher/metric/metric_length.hpp"

namespace anisofront {

/// A vertex of the mesh in the making: place, metric there, background triangle that holds it.
struct WorkVertex {
  Point p;
  MetricFactor r;
  Index hint = 0;
};

/// Three anticlockwise vertices; neighbours[k] lies across the edge opposite vertices[k]: a
/// triangle, or ~s for segment s, on whose other side other triangles of ours may lie (interfaces):
/// segments are never swapped, split or crossed, so each region keeps to itself.
struct WorkTriangle {
  std::array<Index, 3> vertices{kNoIndex, kNoIndex, kNoIndex};
  std::array<Index, 3> neighbours{kNoIndex, kNoIndex, kNoIndex};
  bool dead() const { return vertices[0] == kNoIndex; }
};

inline constexpr std::array<int, 3> kNext{1, 2, 0};
inline constexpr std::array<int, 3> kPrevious{2, 0, 1};

/// A unit edge on a curve of the domain, directed along the curve. A side without region is
/// outside.
struct Segment {
  Index a = kNoIndex, b = kNoIndex;
  Index curve = kNoIndex;
  double parameter_a = 0, parameter_b = 0;
  Index left_region = kNoIndex, right_region = kNoIndex;
};

struct WorkMesh {
  std::vector<WorkVertex> vertices;
  std::vector<WorkTriangle> triangles;
  std::vector<Segment> segments;
};

/// Metric length of the edge between two vertices (log-mean of the two end metrics).
inline double edge_length(const WorkVertex& a, const WorkVertex& b) {
  const Vector u = b.p - a.p;
  return log_mean_length(squared_length(a.r, u), squared_length(b.r, u));
}

/// alpha (Eqn 15b) of the triangle abc in a constant metric: 1 for a unit equilateral triangle,
/// negative when clockwise.
inline double alpha_in(const MetricFactor& r, Point a, Point b, Point c) {
  const Vector u = b - a, v = c - a;
  const Vector p{r.a * u.x + r.b * u.y, r.c * u.y};
  const Vector q{r.a * v.x + r.b * v.y, r.c * v.y};
  constexpr double kTwoSqrt3 = 3.4641016151377544;
  return kTwoSqrt3 * cross(p, q) / (squared_norm(p) + squared_norm(q) + squared_norm(q - p));
}

/// Sum of three factors; alpha does not depend on the scale, so it serves as their mean.
inline MetricFactor sum(const MetricFactor& x, const MetricFactor& y, const MetricFactor& z) {
  return {x.a + y.a + z.a, x.b + y.b + z.b, x.c + y.c + z.c};
}

/// alpha in the mean metric of the three vertices: a third of the cost of alpha~, used in the
/// loops.
inline double mean_alpha(const WorkVertex& a, const WorkVertex& b, const WorkVertex& c) {
  return alpha_in(sum(a.r, b.r, c.r), a.p, b.p, c.p);
}

/// alpha~ (Eqn 15a): the smallest of the alphas in the three vertex metrics.
inline double least_alpha(const WorkVertex& a, const WorkVertex& b, const WorkVertex& c) {
  const double x = alpha_in(a.r, a.p, b.p, c.p);
  const double y = alpha_in(b.r, a.p, b.p, c.p);
  const double z = alpha_in(c.r, a.p, b.p, c.p);
  return std::fmin(x, std::fmin(y, z));
}

}  // namespace anisofront
