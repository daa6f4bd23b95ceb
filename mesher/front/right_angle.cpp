#include "mesher/front/right_angle.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {
namespace {

/// Half way in ratio between a leg, 1, and a hypotenuse, sqrt 2.
constexpr double kLongestLeg = 1.2;

/// v turned by +90 degrees in the metric and brought to the given length there (Eqn 12 with
/// cosine 0).
Vector turned(const MetricFactor& r, Vector v, double wanted) {
  const double s = r.a * v.x + r.b * v.y, t = r.c * v.y;
  const double scale = wanted / std::sqrt(s * s + t * t);
  const double y = scale * s / r.c;
  return {(-scale * t - r.b * y) / r.a, y};
}

TrialPoint trial_at(const BackgroundMesh& background, Point p, Index hint) {
  TrialPoint trial{p, {}, hint};
  trial.r = background.factor_at(trial.p, trial.hint);
  return trial;
}

/// The end of a leg turned about `foot`, and moved along until their distance is 1 (Eqn 22).
TrialPoint above(const BackgroundMesh& background, const WorkVertex& foot, Vector leg, int steps) {
  constexpr double kGoodEnough = 0.03, kShortest = 0.7, kLongest = 1.4;
  TrialPoint trial = trial_at(background, foot.p + turned(foot.r, leg, 1), foot.hint);
  for (int step = 0; step < steps; ++step) {
    const double length = edge_length(foot, {trial.p, trial.r, trial.hint});
    if (std::fabs(length - 1) < kGoodEnough) break;
    const double scale = 1 / std::clamp(length, kShortest, kLongest);
    trial = trial_at(background, foot.p + scale * (trial.p - foot.p), trial.hint);
  }
  return trial;
}

}  // namespace

RightAngleOffset right_angle_offset(const BackgroundMesh& background, const WorkVertex& a,
                                    const WorkVertex& b, int steps) {
  constexpr double kHalfDiagonal = 0.70710678118654752;
  constexpr double kClearly = 1.001;
  const Vector u = b.p - a.p;
  const Point middle = 0.5 * (a.p + b.p);
  if (edge_length(a, b) > kLongestLeg) {
    Index hint = a.hint;
    const MetricFactor r = background.factor_at(middle, hint);
    return {middle, {trial_at(background, middle + turned(r, u, kHalfDiagonal), hint)}, 1};
  }
  const TrialPoint above_a = above(background, a, u, steps),
                   above_b = above(background, b, u, steps);
  const double mu_a = right_angle_mu(a, b, above_a.p, above_a.r);
  const double mu_b = right_angle_mu(a, b, above_b.p, above_b.r);
  if (mu_b > kClearly * mu_a) return {middle, {above_b, above_a}, 2};
  return {middle, {above_a, above_b}, 2};
}

double right_angle_mu(const WorkVertex& a, const WorkVertex& b, Point c, const MetricFactor& at_c) {
  constexpr double kThird = 1. / 3;
  const MetricFactor s = sum(a.r, b.r, at_c);
  const MetricFactor r{s.a * kThird, s.b * kThird, s.c * kThird};
  const Vector u = b.p - a.p, v = c - a.p, w = c - b.p;
  const double twice_area = r.a * r.c * cross(u, v);
  if (twice_area <= 0) return -1;
  const double uu = squared_length(r, u), vv = squared_length(r, v), ww = squared_length(r, w);
  const double lu = std::sqrt(uu), lv = std::sqrt(vv), lw = std::sqrt(ww);
  const auto half_square = [&](double pp, double qq, double p, double q) {
    const double delta = 0.5 * (std::fabs(p - 1) + std::fabs(q - 1));
    return 2 * twice_area / ((pp + qq) * (1 + delta + 0.5 * delta * delta));
  };
  return std::max(
      {half_square(uu, vv, lu, lv), half_square(uu, ww, lu, lw), half_square(vv, ww, lv, lw)});
}

}  // namespace anisofront
