#pragma once

#include <vector>

#include "mesher/metric/metric_field.hpp"

namespace anisofront {

/// Logarithmic mean of the lengths in two end metrics, given their squares: the exact length when
/// the size varies geometrically. As (2 G + A) / 3, no libm: error 1e-4 at a ratio of 2.
inline double log_mean_length(double squared1, double squared2) {
  const double x = std::sqrt(squared1), y = std::sqrt(squared2);
  return (2 * std::sqrt(x * y) + 0.5 * (x + y)) * (1. / 3);
}

/// Two-point formula (A12) from the squared lengths of one vector in the two end metrics.
inline double trapezoid_length(double squared1, double squared2) {
  return 0.5 * (std::sqrt(squared1) + std::sqrt(squared2));
}

/// Simpson's rule from the squared lengths in the metrics at both ends and at the middle: exact
/// when the density 1/h is a cubic. For decisions that may cost one more look-up, like splits.
inline double simpson_length(double squared1, double squared_middle, double squared2) {
  return (std::sqrt(squared1) + 4 * std::sqrt(squared_middle) + std::sqrt(squared2)) * (1. / 6);
}

/// Length of the segment ab by Appendix B (A10-A12): bisected until every sub-segment is shorter
/// than `tolerance` (only the sub-segments above it, see ERRATA), trapezoid rule on each.
/// At least two sub-segments; at most 2^20 of them. 0 when a == b.
double segment_length(const MetricFunction& metric, Point a, Point b, double tolerance = 0.25);

/// Running lengths of Appendix B: nodes at parameters t[i] in [0,1] with length[i] from a; t
/// ascends from 0 to 1.
struct SegmentProfile {
  std::vector<double> t;
  std::vector<double> length;
};
SegmentProfile segment_profile(const MetricFunction& metric, Point a, Point b,
                               double tolerance = 0.25);

/// Parameter in [0,1] of the metric midpoint (A13 with ERRATA: half of the segment's own length);
/// 0.5 when a == b.
double metric_midpoint(const MetricFunction& metric, Point a, Point b, double tolerance = 0.25);

/// Where one sub-segment begins or ends: its parameter and the density of length there.
struct SegmentNode {
  double t = 0;
  double density = 0;
};

namespace detail {
inline constexpr int kMaxBisections = 20;

template <class Density, class Visit>
void bisect(const Density& density, SegmentNode a, SegmentNode b, double tolerance, int level,
            Visit& visit) {
  const double length = 0.5 * (b.t - a.t) * (a.density + b.density);  // A12
  if (level > 0 && (length < tolerance || level >= kMaxBisections)) {
    visit(b.t, length);
    return;
  }
  const double t = 0.5 * (a.t + b.t);
  const SegmentNode middle{t, density(t)};
  bisect(density, a, middle, tolerance, level + 1, visit);
  bisect(density, middle, b, tolerance, level + 1, visit);
}
}  // namespace detail

/// Appendix B for any density of length over t in [0,1], whose end values are given: calls
/// visit(end of the sub-segment, length) from left to right.
template <class Density, class Visit>
void for_each_sub_segment(const Density& density, double density_at_0, double density_at_1,
                          double tolerance, Visit visit) {
  detail::bisect(density, {0, density_at_0}, {1, density_at_1}, tolerance, 0, visit);
}

}  // namespace anisofront
