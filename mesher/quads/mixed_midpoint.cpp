#include "mesher/quads/mixed_midpoint.hpp"

#include <cmath>

#include "mesher/quads/on_curve.hpp"

namespace anisofront {
namespace {

/// Share of the vector u that holds the share `part` of the length, if the density of length varies
/// linearly between the two metrics, as the trapezoid rule (A12) assumes.
double share_of_length(const MetricFactor& at_start, const MetricFactor& at_end, Vector u,
                       double part) {
  const double x = length(at_start, u), y = length(at_end, u);
  const double target = 0.5 * part * (x + y);
  const double s = 2 * target / (x + std::sqrt(x * x + 2 * (y - x) * target));
  return s >= 0 ? std::fmin(s, 1) : 0.5;  // not a number where the length vanishes
}

}  // namespace

WorkVertex MidpointFinder::look_up(Point p, Index hint) const {
  WorkVertex v{p, {}, hint};
  v.r = background_.factor_at(p, v.hint);
  return v;
}

template <class Place>
void MidpointFinder::sample(const Sample& from, const Sample& to, const Place& place, int level) {
  const Vector u = to.vertex.p - from.vertex.p;
  const double length =
      trapezoid_length(squared_length(from.vertex.r, u), squared_length(to.vertex.r, u));  // A12
  if (level > 0 && (length < tolerance_ || level >= detail::kMaxBisections)) {
    samples_.push_back({to.t, to.vertex, length});
    return;
  }
  const double t = 0.5 * (from.t + to.t);
  const Sample middle{t, look_up(place(t), from.vertex.hint), 0};
  sample(from, middle, place, level + 1);
  sample(middle, to, place, level + 1);
}

template <class Place>
double MidpointFinder::halving_parameter(const Sample& from, const Sample& to, const Place& place) {
  samples_.assign(1, from);
  sample(from, to, place, 0);
  double rest = 0;
  for (const Sample& s : samples_) rest += 0.5 * s.length;  // A11
  std::size_t j = 1;
  while (j + 1 < samples_.size() && samples_[j].length < rest) rest -= samples_[j++].length;  // A13
  const Sample &a = samples_[j - 1], &b = samples_[j];
  const double share =
      share_of_length(a.vertex.r, b.vertex.r, b.vertex.p - a.vertex.p, rest / b.length);
  return std::lerp(a.t, b.t, share);
}

WorkVertex MidpointFinder::of_edge(const WorkVertex& a, const WorkVertex& b) {
  const auto place = [&](double t) { return lerp(a.p, b.p, t); };
  return look_up(place(halving_parameter({0, a, 0}, {1, b, 0}, place)), a.hint);
}

MidpointFinder::OnCurve MidpointFinder::of_segment(const NurbsCurve& curve, const Segment& segment,
                                                   const WorkVertex& a, const WorkVertex& b) {
  const auto place = [&](double t) { return point_between(curve, t, a.p, b.p); };
  const double t =
      halving_parameter({segment.parameter_a, a, 0}, {segment.parameter_b, b, 0}, place);
  return {t, look_up(place(t), a.hint)};
}

}  // namespace anisofront
