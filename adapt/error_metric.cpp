#include "adapt/error_metric.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/topology.hpp"
#include "mesher/metric/gradation.hpp"
#include "mesher/metric/metric_length.hpp"
#include "mesher/metric/statistics.hpp"

namespace anisofront {
namespace {

constexpr double kScaleTolerance = 1e-4;
constexpr int kMaxChords = 60;
/// Steps of log D that look for a bracket: doubled from the first to the last.
constexpr double kFirstStep = 0.1, kLastStep = 30;

/// Absolute eigenvalues of a symmetric tensor, the larger first.
PrincipalMetric absolute(const Hessian& h) {
  const double mean = 0.5 * (h.xx + h.yy), half = 0.5 * (h.xx - h.yy);
  const double radius = std::hypot(half, h.xy);
  const double angle = 0.5 * std::atan2(h.xy, half);  // of the eigenvector of mean + radius
  const Vector upper{std::cos(angle), std::sin(angle)};
  const double l1 = std::abs(mean + radius), l2 = std::abs(mean - radius);
  return l1 >= l2 ? PrincipalMetric{l1, l2, upper} : PrincipalMetric{l2, l1, {-upper.y, upper.x}};
}

void require_target(double target, const MetricLimits& limits) {
  if (!(target > 0) || !std::isfinite(target))
    throw InputError("target size of the mesh is " + std::to_string(target) +
                     ", expected a positive number");
  if (!(limits.hmin >= 0 && limits.hmax > limits.hmin && limits.stretch >= 1))
    throw InputError("limits: hmin = " + std::to_string(limits.hmin) + ", hmax = " +
                     std::to_string(limits.hmax) + ", stretch = " + std::to_string(limits.stretch) +
                     "; expected 0 <= hmin < hmax and stretch >= 1");
}

MetricField scaled(const Mesh& mesh, const PrincipalField& density, double factor,
                   const MetricLimits& limits) {
  MetricField field;
  field.reserve(density.size());
  for (const auto& [l1, l2, e1] : density)
    field.push_back(metric_of(limited({factor * l1, factor * l2, e1}, limits)));
  limit_gradation(mesh, field, limits.gradation);
  return field;
}

/// A factor that was tried.
struct Trial {
  double log_factor = 0;
  double excess = 0;  ///< log(measure / target)
};

/// Zero of the chord through two trials of opposite sign, kept away from the ends of the bracket.
double chord(const Trial& low, const Trial& high) {
  const double t = low.excess / (low.excess - high.excess);
  return low.log_factor + std::clamp(t, 0.05, 0.95) * (high.log_factor - low.log_factor);
}

}  // namespace

Metric metric_of(const PrincipalMetric& m) {
  const double d = m.l1 - m.l2;
  return {m.l2 + d * m.e1.x * m.e1.x, d * m.e1.x * m.e1.y, m.l2 + d * m.e1.y * m.e1.y};
}

PrincipalField absolute_hessians(std::span<const LocalQuadratic> quadratics, AdaptMode mode,
                                 double floor) {
  PrincipalField field;
  double largest = 0;
  for (const LocalQuadratic& q : quadratics) {
    field.push_back(absolute(q.hessian));
    largest = std::max(largest, field.back().l1);
  }
  const double least = largest > 0 ? floor * largest : 1;
  for (PrincipalMetric& m : field) {
    m.l1 = std::max(m.l1, least);
    m.l2 = mode == AdaptMode::isotropic ? m.l1 : std::max(m.l2, least);
  }
  return field;
}

PrincipalField lp_density(PrincipalField absolute_hessians, double p) {
  for (PrincipalMetric& m : absolute_hessians) {
    const double factor = std::pow(m.l1 * m.l2, -1 / (2 * p + 2));
    m.l1 *= factor;
    m.l2 *= factor;
  }
  return absolute_hessians;
}

PrincipalMetric limited(PrincipalMetric m, const MetricLimits& limits) {
  const double least = 1 / (limits.hmax * limits.hmax);
  const double most = 1 / (limits.hmin * limits.hmin);  // infinite when there is no hmin
  m.l1 = std::clamp(m.l1, least, most);
  m.l2 = std::clamp(m.l2, least, most);
  m.l2 = std::max(m.l2, m.l1 / (limits.stretch * limits.stretch));
  return m;
}

double complexity(const Mesh& mesh, const MetricField& field) {
  return metric_complexity(mesh, field) * std::sqrt(3.) / 4;
}

double expected_vertices(const Mesh& mesh, const MetricField& field) {
  double boundary = 0;
  for (const auto& [a, b] : boundary_edges(mesh)) {
    const Vector d = mesh.points[b] - mesh.points[a];
    boundary += log_mean_length(squared_length(field[a], d), squared_length(field[b], d));
  }
  return 1 + 0.5 * (metric_complexity(mesh, field) + boundary);
}

ScaledMetric scale_metric(const Mesh& mesh, const PrincipalField& density,
                          const MetricMeasure& measure, double target, const MetricLimits& limits) {
  require_target(target, limits);
  ScaledMetric best;
  const auto try_factor = [&](double log_factor) {
    best.field = scaled(mesh, density, std::exp(log_factor), limits);
    best.measure = measure(mesh, best.field);
    return Trial{log_factor, std::log(best.measure / target)};
  };
  // Without limits the measure is nearly proportional to the factor.
  const double first = target / measure(mesh, scaled(mesh, density, 1, {}));
  Trial low = try_factor(std::log(first)), high = low, last = low;
  for (double step = kFirstStep; high.excess < 0 && step < kLastStep; step *= 2) {
    low = high;
    last = high = try_factor(high.log_factor + step);
  }
  for (double step = kFirstStep; low.excess > 0 && step < kLastStep; step *= 2) {
    high = low;
    last = low = try_factor(low.log_factor - step);
  }
  if (high.excess < 0 || low.excess > 0) return best;  // the limits forbid the target
  for (int k = 0; k < kMaxChords && std::abs(last.excess) > kScaleTolerance; ++k) {
    last = try_factor(chord(low, high));
    (last.excess < 0 ? low : high) = last;
  }
  return best;
}

}  // namespace anisofront
