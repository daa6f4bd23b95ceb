#include "drivers/report/figure_slope.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace anisofront {
namespace {

constexpr std::size_t kManyCurves = 12;

/// Points of the curves by twice their rounded order.
using Halves = std::map<int, std::vector<ErrorPoint>>;

/// All points, under the order that most of them have.
void keep_commonest(Halves& halves) {
  if (halves.empty()) return;
  const auto commonest = std::max_element(
      halves.begin(), halves.end(),
      [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
  std::vector<ErrorPoint> all;
  for (const auto& [order, points] : halves) all.insert(all.end(), points.begin(), points.end());
  halves = {{commonest->first, all}};
}

ReferenceSlope slope_below(double order, const std::vector<ErrorPoint>& points) {
  constexpr double kGap = 0.6;
  ReferenceSlope slope{order, HUGE_VAL, HUGE_VAL, 0};
  for (const auto& [unknowns, error] : points) {
    slope.factor = std::min(slope.factor, kGap * error * std::pow(unknowns, order));
    slope.first = std::min(slope.first, unknowns);
    slope.last = std::max(slope.last, unknowns);
  }
  return slope;
}

}  // namespace

std::optional<double> measured_order(const std::vector<ErrorPoint>& points) {
  constexpr double kLeastSpan = 2;
  if (points.size() < 2) return {};
  const auto [low, high] = std::minmax_element(points.begin(), points.end());
  if (high->first < kLeastSpan * low->first) return {};
  const auto n = static_cast<double>(points.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [unknowns, error] : points) {
    const double a = std::log(unknowns), b = std::log(error);
    x += a, y += b, xx += a * a, xy += a * b;
  }
  return -(n * xy - x * y) / (n * xx - x * x);
}

std::vector<ReferenceSlope> reference_slopes(const std::vector<std::vector<ErrorPoint>>& curves) {
  Halves halves;
  for (const std::vector<ErrorPoint>& curve : curves) {
    const std::optional<double> order = measured_order(curve);
    const int rounded = order ? static_cast<int>(std::lround(2 * *order)) : 0;
    if (rounded > 0) halves[rounded].insert(halves[rounded].end(), curve.begin(), curve.end());
  }
  if (curves.size() > kManyCurves) keep_commonest(halves);
  std::vector<ReferenceSlope> slopes;
  for (const auto& [order, points] : halves) slopes.push_back(slope_below(0.5 * order, points));
  return slopes;
}

}  // namespace anisofront
