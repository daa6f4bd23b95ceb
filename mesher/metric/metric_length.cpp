#include "mesher/metric/metric_length.hpp"

#include <algorithm>

namespace anisofront {

SegmentProfile segment_profile(const MetricFunction& metric, Point a, Point b, double tolerance) {
  const auto density = [&](double t) { return length(metric(lerp(a, b, t)), b - a); };  // Eqn 1a
  SegmentProfile profile{{0}, {0}};
  for_each_sub_segment(density, density(0), density(1), tolerance, [&](double end, double piece) {
    profile.t.push_back(end);
    profile.length.push_back(profile.length.back() + piece);  // A11
  });
  return profile;
}

double segment_length(const MetricFunction& metric, Point a, Point b, double tolerance) {
  const auto density = [&](double t) { return length(metric(lerp(a, b, t)), b - a); };
  double sum = 0;
  for_each_sub_segment(density, density(0), density(1), tolerance,
                       [&sum](double, double piece) { sum += piece; });
  return sum;
}

double metric_midpoint(const MetricFunction& metric, Point a, Point b, double tolerance) {
  const auto [t, running] = segment_profile(metric, a, b, tolerance);
  const double half = 0.5 * running.back();
  if (!(half > 0)) return 0.5;
  const auto j = static_cast<std::size_t>(
      std::lower_bound(running.begin() + 1, running.end() - 1, half) - running.begin());  // A13
  return t[j - 1] + (t[j] - t[j - 1]) * (half - running[j - 1]) / (running[j] - running[j - 1]);
}

}  // namespace anisofront
