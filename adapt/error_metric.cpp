#include "adapt/error_metric.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/topology.hpp"
#include "mesher/metric/gradation.hpp"
#include "mesher/metric/intersection.hpp"
#include "mesher/metric/metric_length.hpp"
#include "mesher/metric/statistics.hpp"

namespace anisofront {
namespace {

constexpr double kScaleTolerance = 1e-4, kGradedTolerance = 5e-4;
constexpr int kMaxTrials = 60, kMaxGradedTrials = 15;
/// Largest single step of the logarithm of the factor, and how far it may go from its first value.
constexpr double kMaxStep = 6, kMaxDistance = 50;
constexpr double kLeastSlope = 0.02;

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

void require_one_per_vertex(const Mesh& mesh, std::size_t entries, const char* what) {
  if (entries != mesh.points.size())
    throw InputError(std::string(what) + " has " + std::to_string(entries) +
                     " entries, expected one per vertex: " + std::to_string(mesh.points.size()));
}

/// A factor that was tried.
struct Trial {
  double log_factor = 0;
  double excess = 0;  ///< log(measure / target)
};

/// Zero of a growing function of the factor: secant steps, halving where they leave the bracket.
/// Its slope is near one where no limit bites. The last trial when there is no zero.
template <class Excess>
Trial find_factor(const Excess& excess, double start, double tolerance, int max_trials) {
  double low = -std::numeric_limits<double>::infinity(), high = -low, slope = 1;
  Trial now{start, excess(start)};
  for (int k = 1; k < max_trials && std::abs(now.excess) > tolerance; ++k) {
    (now.excess < 0 ? low : high) = now.log_factor;
    double next = now.log_factor - std::clamp(now.excess / slope, -kMaxStep, kMaxStep);
    if (next <= low || next >= high) next = 0.5 * (low + high);
    if (std::abs(next - start) > kMaxDistance || next == now.log_factor) break;
    const Trial last = std::exchange(now, {next, excess(next)});
    slope = (now.excess - last.excess) / (now.log_factor - last.log_factor);
    slope = std::max(slope, kLeastSlope);
  }
  return now;
}

double boundary_length(const Mesh& mesh, const std::vector<std::array<Index, 2>>& boundary,
                       const MetricField& field) {
  double length = 0;
  for (const auto& [a, b] : boundary) {
    const Vector d = mesh.points[b] - mesh.points[a];
    length += log_mean_length(squared_length(field[a], d), squared_length(field[b], d));
  }
  return length;
}

}  // namespace

Metric metric_of(const PrincipalMetric& m) {
  const double d = m.l1 - m.l2;
  return {m.l2 + d * m.e1.x * m.e1.x, d * m.e1.x * m.e1.y, m.l2 + d * m.e1.y * m.e1.y};
}

PrincipalMetric principal_of(const Metric& m) {
  const PrincipalAxes axes = principal_axes(m);
  return {1 / (axes.h1 * axes.h1), 1 / (axes.h2 * axes.h2), axes.e1};
}

void lift_to_floor(PrincipalField& field, AdaptMode mode, double floor) {
  double largest = 0;
  for (const PrincipalMetric& m : field) largest = std::max(largest, m.l1);
  const double least = largest > 0 ? floor * largest : 1;
  for (PrincipalMetric& m : field) {
    m.l1 = std::max(m.l1, least);
    m.l2 = mode == AdaptMode::isotropic ? m.l1 : std::max(m.l2, least);
  }
}

PrincipalField absolute_hessians(std::span<const LocalQuadratic> quadratics, AdaptMode mode,
                                 double floor) {
  PrincipalField field;
  for (const LocalQuadratic& q : quadratics) field.push_back(absolute(q.hessian));
  lift_to_floor(field, mode, floor);
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

PrincipalField energy_density(PrincipalField absolute_hessians) {
  for (PrincipalMetric& m : absolute_hessians) {
    const double root = std::sqrt(m.l1 / m.l2);
    m = {m.l1 * root, m.l2 / root, m.e1};
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
  return vertex_measure(mesh)(mesh, field);
}

MetricMeasure vertex_measure(const Mesh& mesh, Elements elements) {
  return [boundary = boundary_edges(mesh), elements](const Mesh& same, const MetricField& field) {
    const double inside = elements == Elements::triangle ? 0.5 * metric_complexity(same, field)
                                                         : complexity(same, field);
    return 1 + inside + 0.5 * boundary_length(same, boundary, field);
  };
}

MetricField bounded_metric(const PrincipalField& density, double factor, const MetricLimits& limits,
                           std::span<const Metric> beside) {
  MetricField field(density.size());
#pragma omp parallel for schedule(static)
  for (std::size_t v = 0; v < density.size(); ++v) {
    PrincipalMetric m{factor * density[v].l1, factor * density[v].l2, density[v].e1};
    if (!beside.empty()) m = principal_of(intersect(metric_of(m), beside[v]));
    field[v] = metric_of(limited(m, limits));
  }
  return field;
}

ScaledMetric scale_metric(const Mesh& mesh, const PrincipalField& density,
                          const MetricMeasure& measure, double target, const MetricLimits& limits,
                          std::span<const Metric> beside) {
  require_target(target, limits);
  require_one_per_vertex(mesh, density.size(), "the density of the metric");
  if (!beside.empty()) require_one_per_vertex(mesh, beside.size(), "the metric beside the density");
  ScaledMetric result;
  const auto excess_with = [&](double gradation) {
    return [&, gradation](double log_factor) {
      result.factor = std::exp(log_factor);
      result.field = bounded_metric(density, result.factor, limits, beside);
      limit_gradation(mesh, result.field, gradation);
      result.measure = measure(mesh, result.field);
      return std::log(result.measure / target);
    };
  };
  // Without limits the measure is nearly proportional to the factor.
  const double first = target / measure(mesh, bounded_metric(density, 1, {}));
  if (!(first > 0) || !std::isfinite(first))
    throw InputError("the density of the metric has no finite integral; expected positive " +
                     std::string("eigenvalues and unit vectors at every vertex"));
  const Trial ungraded = find_factor(excess_with(0), std::log(first), kScaleTolerance, kMaxTrials);
  if (limits.gradation > 1)
    find_factor(excess_with(limits.gradation), ungraded.log_factor, kGradedTolerance,
                kMaxGradedTrials);
  return result;
}

}  // namespace anisofront
