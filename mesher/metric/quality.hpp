#pragma once

#include <array>
#include <span>

#include "mesher/metric/metric.hpp"

namespace anisofront {

/// alpha^ of the triangle in one constant metric (Eqn 15b with ERRATA: sqrt(det M)); 1 for the
/// metric-equilateral triangle, negative when clockwise, 0 when flat.
inline double alpha(const MetricFactor& m, Point p1, Point p2, Point p3) {
  constexpr double kTwoSqrt3 = 3.4641016151377544;
  const Vector u = p2 - p1, v = p3 - p1, w = p3 - p2;
  const double squares = squared_length(m, u) + squared_length(m, v) + squared_length(m, w);
  return squares > 0 ? kTwoSqrt3 * m.a * m.c * cross(u, v) / squares : 0;
}

/// alpha~: the least alpha^ over the metrics at the three vertices (Eqn 15a); in [-1, 1].
double alpha(const std::array<MetricFactor, 3>& m, const std::array<Point, 3>& p);
double alpha(const std::array<Metric, 3>& m, const std::array<Point, 3>& p);

/// beta~ of a quadrilateral (Eqns 16a, 16b): the four triangles cut off by the two diagonals,
/// product of the two least alpha~ over that of the two largest. 1 for squares and rectangles; -1
/// when an alpha~ is not positive, that is for concave, flat or clockwise quadrilaterals (ERRATA).
/// In (0, 1] otherwise.
double beta(const std::array<MetricFactor, 4>& m, const std::array<Point, 4>& p);
double beta(const std::array<Metric, 4>& m, const std::array<Point, 4>& p);

/// shape * exp(-delta), delta the mean of |l - 1| over the edges (Eqns 17a, 17b). `shape` is
/// alpha~ or beta~, `lengths` the metric lengths of the edges (at least one).
double mu(double shape, std::span<const double> lengths);

/// mu~ with each edge measured by (A12) in the metrics at its two ends (ERRATA, 17b), hence
/// independent of the direction in which the element is traversed.
double mu(const std::array<Metric, 3>& m, const std::array<Point, 3>& p);
double mu(const std::array<Metric, 4>& m, const std::array<Point, 4>& p);

}  // namespace anisofront
