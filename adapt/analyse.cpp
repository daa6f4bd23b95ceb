#include "adapt/analyse.hpp"

#include <cmath>
#include <string>

#include "adapt/energy_estimate.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/geometry/stopwatch.hpp"
#include "mesher/metric/gradation.hpp"

namespace anisofront {
namespace {

/// A metric whose size misses what was asked for by more than this share deserves a warning.
constexpr double kTargetTolerance = 0.01;

/// What an analysis passes on from one of its steps to the next.
struct Estimated {
  int order = 1;
  FieldHessians hessians;
  std::vector<double> contributions;  ///< of the elements to what steers
};

CycleError errors_of(const ErrorEstimate& estimate, const SolvedModel& solved) {
  CycleError error;
  error.estimate = estimate.relative();
  if (!solved.true_error) return error;
  error.relative_energy = *solved.true_error / *solved.true_energy;
  error.effectivity = estimate.error / *solved.true_error;
  return error;
}

/// Warnings go into the analysis.
Monitor recorder(Analysis& analysis) {
  Monitor monitor;
  monitor.warn = [&analysis](const std::string& text) { analysis.warnings.push_back(text); };
  return monitor;
}

FieldHessians field_hessians(const FeMesh& mesh, const std::vector<double>& curvature_values,
                             int components, const RecoveredFlux& recovered) {
  if (!curvature_values.empty()) return hessians_of(mesh.mesh, curvature_values, components);
  return hessians_of(mesh.mesh, recovered.vertex_values(), recovered.components(),
                     AcrossInterfaces::jump);
}

/// Records the goal with its error; returns the Hessians that its metric is made of.
FieldHessians analyse_goal(const FeMesh& mesh, const SolvedModel& solved,
                           const RecoveredFlux& recovered, const FieldHessians& hessians,
                           Analysis& analysis) {
  const SolvedGoal& goal = *solved.goal;
  const RecoveredFlux dual(mesh, goal.dual);
  GoalEstimate estimate = estimate_goal(mesh, solved.flux, recovered, goal.dual, dual, goal.tying);
  analysis.goal = GoalRecord{goal.value, estimate.error};
  const FieldHessians dual_hessians =
      field_hessians(mesh, goal.dual_curvature_values, solved.curvature_components, dual);
  FieldHessians weighted{goal_hessians(hessians, dual_hessians, estimate)};
  analysis.element_fields.push_back({"goal indicator", 1, std::move(estimate.indicators)});
  return weighted;
}

/// Solves and estimates; fills everything of the analysis but the metric.
Estimated solve_and_estimate(const FeMesh& mesh, const Model& model, bool use_goal,
                             Analysis& analysis) {
  Stopwatch watch;
  SolvedModel solved = model(mesh, recorder(analysis));
  analysis.solve_seconds = watch.lap() - solved.truth_seconds;
  const RecoveredFlux recovered(mesh, solved.flux);
  ErrorEstimate estimate = estimate_by_recovery(mesh, solved.flux, recovered, solved.extra_energy);
  analysis.error = errors_of(estimate, solved);
  analysis.dofs = solved.dofs;
  analysis.values = std::move(solved.values);
  analysis.vertex_fields = std::move(solved.vertex_fields);
  analysis.estimate_seconds = watch.lap();
  Estimated estimated{
      solved.order,
      field_hessians(mesh, solved.curvature_values, solved.curvature_components, recovered),
      {}};
  for (const double indicator : estimate.indicators)
    estimated.contributions.push_back(indicator * indicator);
  analysis.element_fields.push_back({"indicator", 1, std::move(estimate.indicators)});
  if (solved.goal) {
    FieldHessians weighted = analyse_goal(mesh, solved, recovered, estimated.hessians, analysis);
    if (use_goal) {
      estimated.hessians = std::move(weighted);
      estimated.contributions = analysis.element_fields.back().values;
    }
  }
  analysis.metric_seconds = watch.lap();
  return estimated;
}

std::string limit_warning(double wanted, double reached) {
  return "the limits hmin, hmax and stretch allow a mesh of about " +
         std::to_string(std::llround(reached)) + " vertices, " +
         std::to_string(std::llround(wanted)) + " were asked for";
}

StageOptions stage_options(const AdaptSettings& settings, int cycle) {
  StageOptions options;
  options.density = settings.density;
  if (settings.use_goal) {
    options.density.norm = MetricNorm::lp;
    options.density.p = 1;
  }
  options.limits = settings.limits;
  options.align = settings.align;
  options.use_layer_metric = settings.layer_metric && cycle == 0;
  options.elements = settings.elements;
  options.keep_stages = settings.keep_stages;
  return options;
}

void add_metric(const FeMesh& mesh, Estimated estimated, const AdaptSettings& settings, int cycle,
                Analysis& analysis) {
  Stopwatch watch;
  const SteeringError steering = settings.use_goal ? steering_error(*analysis.goal, cycle)
                                                   : steering_error(analysis.error, cycle);
  // Errors of a goal are products of two energy errors.
  const int order = settings.use_goal ? 2 * estimated.order : estimated.order;
  analysis.target = target_state(settings.target, steering);
  const double wanted =
      next_vertices(settings.target, order, static_cast<double>(mesh.mesh.points.size()), steering);
  Contributions contributions{{}, estimated.order};
  if (settings.equidistribute && cycle >= kTrustedCycle)
    contributions.values = std::move(estimated.contributions);
  StagedMetric metric = make_metric(mesh, std::move(estimated.hessians), settings.layers, wanted,
                                    stage_options(settings, cycle), contributions);
  // On a coarse mesh an a-priori layer metric is known too badly to count its vertices.
  const bool is_counted = !(settings.layer_metric && cycle == 0);
  if (is_counted && std::abs(metric.measure - wanted) > kTargetTolerance * wanted)
    analysis.warnings.push_back(limit_warning(wanted, metric.measure));
  analysis.next_vertices = is_counted ? metric.measure : wanted;
  analysis.metric = std::move(metric.field);
  analysis.stages = std::move(metric.stages);
  analysis.metric_seconds += watch.lap();
}

void require_positive(const Metric& m, Point p) {
  const double det = determinant(m);
  if (m.m11 > 0 && det > 0 && std::isfinite(det)) return;
  throw InputError("the prescribed metric at (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
                   ") is [[" + std::to_string(m.m11) + ", " + std::to_string(m.m12) + "], [., " +
                   std::to_string(m.m22) + "]], expected finite and positive definite");
}

}  // namespace

Analyse analyse_model(Model model, Domain domain, AdaptSettings settings) {
  require_one_target(settings.target);
  return [model = std::move(model), domain = std::move(domain), settings = std::move(settings)](
             const Mesh& mesh, int cycle) {
    Analysis analysis;
    const FeMesh fe = curved_fe_mesh(mesh, domain, recorder(analysis));
    add_metric(fe, solve_and_estimate(fe, model, settings.use_goal, analysis), settings, cycle,
               analysis);
    return analysis;
  };
}

Analyse analyse_prescribed(MetricFunction metric, double gradation, Model model, Domain domain) {
  return [metric = std::move(metric), gradation, model = std::move(model),
          domain = std::move(domain)](const Mesh& mesh, int) {
    Analysis analysis;
    if (model)
      solve_and_estimate(curved_fe_mesh(mesh, domain, recorder(analysis)), model, false, analysis);
    Stopwatch watch;
    for (const Point& p : mesh.points) {
      analysis.metric.push_back(metric(p));
      require_positive(analysis.metric.back(), p);
    }
    if (gradation > 1) limit_gradation(mesh, analysis.metric, gradation);
    analysis.metric_seconds += watch.lap();
    return analysis;
  };
}

}  // namespace anisofront
