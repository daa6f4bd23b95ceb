#include "mesher/front/ideal_point.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {
namespace {

constexpr double kHalfSqrt3 = 0.86602540378443865;

/// Log-mean length of the side from a vertex to the trial point, and its gradient at the latter in
/// the mean metric.
struct Side {
  double length;
  Vector gradient;
};

Side side_to(const WorkVertex& v, const TrialPoint& trial) {
  const Vector u = trial.p - v.p;
  const double l = log_mean_length(squared_length(v.r, u), squared_length(trial.r, u));
  const MetricFactor r{0.5 * (v.r.a + trial.r.a), 0.5 * (v.r.b + trial.r.b),
                       0.5 * (v.r.c + trial.r.c)};
  const double s = r.a * u.x + r.b * u.y;
  const double t = r.c * u.y;
  const double k = l / (s * s + t * t);
  return {l, {k * r.a * s, k * (r.b * s + r.c * t)}};
}

}  // namespace

Point offset_from_a(const Metric& at_a, Point a, Point b) {
  const Vector u = b - a;
  return a + (1 / length(at_a, u)) * rotate(at_a, u, 0.5, kHalfSqrt3);
}

Point offset_from_b(const Metric& at_b, Point a, Point b) {
  const Vector u = a - b;
  return b + (1 / length(at_b, u)) * rotate(at_b, u, 0.5, -kHalfSqrt3);
}

Point offset_from_midpoint(const Metric& at_d, Point d, Point b) {
  const Vector u = b - d;
  return d + (kHalfSqrt3 / length(at_d, u)) * rotate(at_d, u, 0, 1);
}

Point constant_metric_apex(const MetricFactor& r, Point a, Point b) {
  constexpr double kLeastHeight2 = 0.3;
  const Vector u = b - a;
  const double s = r.a * u.x + r.b * u.y;
  const double t = r.c * u.y;
  const double l2 = s * s + t * t;
  const double height = std::sqrt(std::max(1 - 0.25 * l2, kLeastHeight2) / l2);
  const double y = s * height / r.c;
  return 0.5 * (a + b) + Vector{(-t * height - r.b * y) / r.a, y};
}

void correct_by_newton(const BackgroundMesh& background, const WorkVertex& a, const WorkVertex& b,
                       int steps, TrialPoint& trial) {
  constexpr double kGoodEnough = 0.03, kLongestStep = 0.3;
  for (int step = 0; step < steps; ++step) {
    const Side ac = side_to(a, trial), bc = side_to(b, trial);
    if (std::fabs(ac.length - 1) + std::fabs(bc.length - 1) < kGoodEnough) return;
    const double det = cross(ac.gradient, bc.gradient);
    if (!(std::fabs(det) > 1e-300)) return;
    const double ra = std::clamp(1 - ac.length, -kLongestStep, kLongestStep);
    const double rb = std::clamp(1 - bc.length, -kLongestStep, kLongestStep);
    const Vector move{(ra * bc.gradient.y - rb * ac.gradient.y) / det,
                      (ac.gradient.x * rb - bc.gradient.x * ra) / det};
    const Point next = trial.p + move;
    if (twice_area(a.p, b.p, next) <= 0) return;
    trial.p = next;
    trial.r = background.factor_at(trial.p, trial.hint);
  }
}

double fast_mu(const WorkVertex& a, const WorkVertex& b, Point c, const MetricFactor& at_c) {
  const MetricFactor s = sum(a.r, b.r, at_c);
  const MetricFactor r{s.a * (1. / 3), s.b * (1. / 3), s.c * (1. / 3)};
  const double alpha = alpha_in(r, a.p, b.p, c);
  if (alpha <= 0) return -1;
  const double delta =
      (std::fabs(length(r, c - a.p) - 1) + std::fabs(length(r, c - b.p) - 1)) * (1. / 3);
  return alpha / (1 + delta + 0.5 * delta * delta);
}

}  // namespace anisofront
