// The continuous-mesh metric of one field is that of A. Loseille, F. Alauzet (see
// error_metric.hpp); for stresses recovered from second-order elements the same formula makes their
// interpolation error small, which is what the energy norm measures.
#include "adapt/density.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/metric/intersection.hpp"

namespace anisofront {
namespace {

constexpr double kNoise = 1e-12;

void require_options(const DensityOptions& options) {
  if (!(options.p >= 1))
    throw InputError("metric density: p is " + describe(options.p) +
                     ", expected an L^p norm with p >= 1");
  if (!(options.curvature_floor > 0 && options.curvature_floor < 1))
    throw InputError("metric density: the curvature floor is " + describe(options.curvature_floor) +
                     ", expected a share between 0 and 1");
}

void require_fields(const Mesh& mesh, const FieldHessians& fields) {
  if (fields.empty()) throw InputError("metric density: no field, expected at least one");
  for (std::size_t c = 0; c < fields.size(); ++c) {
    if (fields[c].size() != mesh.points.size())
      throw InputError("metric density: field " + std::to_string(c + 1) + " has " +
                       std::to_string(fields[c].size()) +
                       " Hessians, expected one per vertex: " + std::to_string(mesh.points.size()));
    for (std::size_t v = 0; v < fields[c].size(); ++v)
      if (const Hessian& h = fields[c][v]; !std::isfinite(h.xx + h.xy + h.yy))
        throw InputError("metric density: the Hessian of field " + std::to_string(c + 1) + " at " +
                         describe(mesh.points[v]) + " is not finite; check the solution there");
  }
}

double largest_entry(const Hessian& h) {
  return std::max({std::abs(h.xx), std::abs(h.xy), std::abs(h.yy)});
}

double largest_entry(const std::vector<Hessian>& field) {
  double largest = 0;
  for (const Hessian& h : field) largest = std::max(largest, largest_entry(h));
  return largest;
}

Hessian divided(const Hessian& h, double by) { return {h.xx / by, h.xy / by, h.yy / by}; }

/// The symmetric root of sum_c H_c^2 at vertex v. With A the H_c below each other this is the root
/// of A'A, whose eigenvalues are the singular values of A: through R = [[a, b], [0, c]] of A = QR,
/// longer column first, so that the smaller one is det R over the larger. (Adding up the squares
/// would lose all curvatures below 1e-8 of the largest.)
/// All in units of the largest entry, whose square may underflow.
PrincipalMetric principal_root(std::span<const std::vector<Hessian>> fields, std::size_t v) {
  double unit = 0;
  for (const std::vector<Hessian>& field : fields) unit = std::max(unit, largest_entry(field[v]));
  if (unit == 0) return {0, 0, {1, 0}};
  double xx = 0, xy = 0, yy = 0;  // A'A
  for (const std::vector<Hessian>& field : fields) {
    const Hessian h = divided(field[v], unit);
    xx += h.xx * h.xx + h.xy * h.xy;
    xy += h.xy * (h.xx + h.yy);
    yy += h.xy * h.xy + h.yy * h.yy;
  }
  const bool x_first = xx >= yy;
  const double first = std::max(xx, yy), slope = xy / first;
  double cc = 0;
  for (const std::vector<Hessian>& field : fields) {
    const Hessian h = divided(field[v], unit);
    const double u = x_first ? h.xy - slope * h.xx : h.xy - slope * h.yy;
    const double w = x_first ? h.yy - slope * h.xy : h.xx - slope * h.xy;
    cc += u * u + w * w;
  }
  const double half = 0.5 * (first - slope * xy - cc), radius = std::hypot(half, xy);
  const double l1 = std::sqrt(0.5 * (first + slope * xy + cc) + radius);
  if (!(radius > 0)) return {unit * l1, unit * l1, {1, 0}};
  const Vector e = (1 / std::hypot(half + radius, xy)) * Vector{half + radius, xy};
  return {unit * l1, unit * std::sqrt(first * cc) / l1, x_first ? e : Vector{e.y, e.x}};
}

PrincipalField absolute_sum(std::span<const std::vector<Hessian>> fields,
                            const DensityOptions& options) {
  PrincipalField field(fields[0].size());
#pragma omp parallel for schedule(static)
  for (std::size_t v = 0; v < field.size(); ++v) field[v] = principal_root(fields, v);
  lift_to_floor(field, options.mode, options.curvature_floor);
  return field;
}

/// Density of the root of the sum of squares of the fields.
PrincipalField density_of(std::span<const std::vector<Hessian>> fields,
                          const DensityOptions& options) {
  PrincipalField absolute = absolute_sum(fields, options);
  return options.norm == MetricNorm::lp ? lp_density(std::move(absolute), options.p)
                                        : energy_density(std::move(absolute));
}

/// The fields that are more than noise; the first of them when all vanish.
std::vector<std::size_t> significant(const FieldHessians& fields) {
  std::vector<double> size;
  for (const std::vector<Hessian>& field : fields) size.push_back(largest_entry(field));
  const double largest = *std::max_element(size.begin(), size.end());
  std::vector<std::size_t> result;
  for (std::size_t c = 0; c < fields.size(); ++c)
    if (size[c] > kNoise * largest) result.push_back(c);
  if (result.empty()) result.push_back(0);
  return result;
}

MetricField with_unit_complexity(const Mesh& mesh, const PrincipalField& density) {
  MetricField field = bounded_metric(density, 1, {});
  const double factor = 1 / complexity(mesh, field);
  for (Metric& m : field) m = scaled(m, factor);
  return field;
}

PrincipalField intersected(const Mesh& mesh, const FieldHessians& fields,
                           const DensityOptions& options) {
  MetricField sum;
  for (const std::size_t c : significant(fields)) {
    MetricField field = with_unit_complexity(mesh, density_of({&fields[c], 1}, options));
    if (sum.empty())
      sum = std::move(field);
    else
      std::transform(sum.begin(), sum.end(), field.begin(), sum.begin(),
                     [](const Metric& a, const Metric& b) { return intersect(a, b); });
  }
  PrincipalField result;
  for (const Metric& m : sum) result.push_back(principal_of(m));
  return result;
}

}  // namespace

PrincipalField metric_density(const Mesh& mesh, const FieldHessians& fields,
                              const DensityOptions& options) {
  require_options(options);
  require_fields(mesh, fields);
  const bool intersects = options.combination == Combination::intersection && fields.size() > 1;
  return intersects ? intersected(mesh, fields, options) : density_of(fields, options);
}

Hessian root_of_squares(const FieldHessians& fields, std::size_t v) {
  const Metric m = metric_of(principal_root(fields, v));
  return {m.m11, m.m12, m.m22};
}

FieldHessians hessians_of(const Mesh& mesh, std::span<const double> values, int components,
                          AcrossInterfaces across) {
  FieldHessians fields;
  for (const auto& quadratics : fit_quadratics(mesh, values, components, across)) {
    fields.emplace_back();
    for (const LocalQuadratic& q : quadratics) fields.back().push_back(q.hessian);
  }
  return fields;
}

}  // namespace anisofront
