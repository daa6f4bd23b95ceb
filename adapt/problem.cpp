#include "adapt/problem.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "adapt/estimate.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/geometry/stopwatch.hpp"
#include "mesher/metric/gradation.hpp"
#include "solver/scalar/norms.hpp"
#include "solver/scalar/solve_scalar.hpp"

namespace anisofront {
namespace {

/// The first meshes do not see the layers and their error says little about the vertices needed:
/// the number changes by at most this factor a cycle. The error aimed at lies a little below the
/// target.
constexpr double kMaxGrowth = 2;
constexpr double kTargetMargin = 0.95;
/// Estimates are believed from this cycle on: on a mesh that misses a layer they are far too small
/// (0.03 of the error for a layer 60 times thinner than the initial cells, 0.7 in cycle 2).
constexpr int kTrustedCycle = 2;
/// A metric whose size misses what was asked for by more than this share deserves a warning.
constexpr double kTargetTolerance = 0.01;

void require_one_target(const AdaptSettings& settings) {
  if (settings.target_vertices.has_value() == settings.target_error.has_value())
    throw UsageError("adapt.target: expected exactly one of error and nodes");
  if (settings.target_error && !(*settings.target_error > 0))
    throw UsageError("adapt.target: the error is " + std::to_string(*settings.target_error) +
                     ", expected a positive number");
}

void require_triangles(const Mesh& mesh) {
  if (!mesh.quads.empty())
    throw InputError("the adaptive loop solves on triangles: found " +
                     std::to_string(mesh.quads.size()) + " quadrilaterals in the mesh");
}

CycleError errors_of(const FeMesh& mesh, const ScalarProblem& problem,
                     const std::optional<ExactSolution>& exact, const ScalarField& u,
                     std::span<const LocalQuadratic> quadratics) {
  const EnergyEstimate estimate = estimate_energy_error(mesh.mesh, problem, u.values, quadratics);
  CycleError error;
  error.estimate = estimate.relative();
  if (!exact) return error;
  const ErrorNorms norms = error_norms(mesh, problem, *exact, u);
  error.relative_energy = norms.relative_energy();
  error.effectivity = estimate.error / norms.energy;
  return error;
}

std::vector<double> nodal_error(const Mesh& mesh, const ExactSolution& exact,
                                const std::vector<double>& u) {
  std::vector<double> error;
  for (std::size_t v = 0; v < u.size(); ++v) error.push_back(exact.value(mesh.points[v]) - u[v]);
  return error;
}

/// The error that the target speaks of, and whether it may end the loop or shrink the mesh.
struct Steering {
  double error = 0;
  bool trusted = false;
};

Steering steering_of(const CycleError& error, int cycle) {
  if (error.relative_energy) return {*error.relative_energy, true};
  return {*error.estimate, cycle >= kTrustedCycle};
}

double next_vertices(const AdaptSettings& settings, double vertices, const Steering& steering) {
  if (settings.target_vertices) return *settings.target_vertices;
  const double ratio = steering.error / (kTargetMargin * *settings.target_error);
  const double least = steering.trusted ? 1 / kMaxGrowth : 1;
  return vertices * std::clamp(ratio * ratio, least, kMaxGrowth);
}

ScaledMetric next_metric(const Mesh& mesh, std::span<const LocalQuadratic> quadratics,
                         const AdaptSettings& settings, double vertices) {
  const PrincipalField density = lp_density(
      absolute_hessians(quadratics, settings.mode, settings.curvature_floor), settings.p);
  return scale_metric(mesh, density, expected_vertices, vertices, settings.limits);
}

TargetState target_state(const AdaptSettings& settings, const Steering& steering) {
  if (!settings.target_error) return TargetState::none;
  return steering.trusted && steering.error <= *settings.target_error ? TargetState::reached
                                                                      : TargetState::missed;
}

std::string limit_warning(double wanted, double reached) {
  return "the limits hmin, hmax and stretch allow a mesh of about " +
         std::to_string(std::llround(reached)) + " vertices, " +
         std::to_string(std::llround(wanted)) + " were asked for";
}

Analysis analyse(const Mesh& mesh, const ScalarProblem& problem,
                 const std::optional<ExactSolution>& exact, const AdaptSettings& settings,
                 int cycle) {
  Analysis analysis;
  Stopwatch watch;
  require_triangles(mesh);
  const FeMesh fe = straight_fe_mesh(mesh);
  const ScalarField field = solve_scalar(fe, problem).field;
  const std::vector<double>& u = field.values;
  analysis.solve_seconds = watch.lap();
  const auto quadratics = fit_quadratics(mesh, u);
  analysis.metric_seconds = watch.lap();
  analysis.error = errors_of(fe, problem, exact, field, quadratics);
  analysis.estimate_seconds = watch.lap();
  analysis.dofs = static_cast<Index>(u.size());
  const Steering steering = steering_of(analysis.error, cycle);
  analysis.target = target_state(settings, steering);
  analysis.vertex_fields.push_back({"u", 1, u});
  if (exact) analysis.vertex_fields.push_back({"error", 1, nodal_error(mesh, *exact, u)});
  watch.lap();
  const auto vertices = static_cast<double>(mesh.points.size());
  const double wanted = next_vertices(settings, vertices, steering);
  ScaledMetric metric = next_metric(mesh, quadratics, settings, wanted);
  if (std::abs(metric.measure - wanted) > kTargetTolerance * wanted)
    analysis.warnings.push_back(limit_warning(wanted, metric.measure));
  analysis.metric = std::move(metric.field);
  analysis.metric_seconds += watch.lap();
  return analysis;
}

void require_positive(const Metric& m, Point p) {
  const double det = determinant(m);
  if (m.m11 > 0 && det > 0 && std::isfinite(det)) return;
  throw InputError("the prescribed metric at (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
                   ") is [[" + std::to_string(m.m11) + ", " + std::to_string(m.m12) + "], [., " +
                   std::to_string(m.m22) + "]], expected finite and positive definite");
}

}  // namespace

Analyse analyse_scalar(ScalarProblem problem, std::optional<ExactSolution> exact,
                       AdaptSettings settings) {
  require_one_target(settings);
  return
      [problem = std::move(problem), exact = std::move(exact), settings](
          const Mesh& mesh, int cycle) { return analyse(mesh, problem, exact, settings, cycle); };
}

Analyse analyse_prescribed(MetricFunction metric, double gradation) {
  return [metric = std::move(metric), gradation](const Mesh& mesh, int) {
    Analysis analysis;
    Stopwatch watch;
    for (const Point& p : mesh.points) {
      analysis.metric.push_back(metric(p));
      require_positive(analysis.metric.back(), p);
    }
    if (gradation > 1) limit_gradation(mesh, analysis.metric, gradation);
    analysis.metric_seconds = watch.lap();
    return analysis;
  };
}

}  // namespace anisofront
