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

struct EstimatedGoal {
  RecoveredFlux dual;
  GoalEstimate estimate;
};

/// A solution with its recovery and estimates, which the metric is made of. What is only for the
/// record has been moved into the analysis.
struct Estimated {
  SolvedModel solved;
  RecoveredFlux recovered;
  std::vector<double> contributions;  ///< of the elements to the squared energy error
  std::optional<EstimatedGoal> goal;
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

SolvedModel solve(const FeMesh& mesh, const Model& model, Analysis& analysis) {
  Stopwatch watch;
  SolvedModel solved = model(mesh, recorder(analysis));
  analysis.solve_seconds = watch.lap() - solved.aside_seconds;
  return solved;
}

/// Records the goal with its error.
EstimatedGoal estimate_goal_of(const FeMesh& mesh, const SolvedModel& solved,
                               const RecoveredFlux& recovered, Analysis& analysis) {
  const SolvedGoal& goal = *solved.goal;
  RecoveredFlux dual(mesh, goal.dual);
  GoalEstimate estimate = estimate_goal(mesh, solved.flux, recovered, goal.dual, dual, goal.tying);
  analysis.goal = GoalRecord{goal.value, estimate.error};
  analysis.element_fields.push_back({"goal indicator", 1, estimate.indicators});
  return {std::move(dual), std::move(estimate)};
}

/// Fills everything of the analysis but the metric.
Estimated estimate(const FeMesh& mesh, SolvedModel solved, Analysis& analysis) {
  Stopwatch watch;
  RecoveredFlux recovered(mesh, solved.flux);
  ErrorEstimate energy = estimate_by_recovery(mesh, solved.flux, recovered, solved.extra_energy);
  analysis.error = errors_of(energy, solved);
  analysis.dofs = solved.dofs;
  analysis.values = std::move(solved.values);
  analysis.vertex_fields = std::move(solved.vertex_fields);
  analysis.profiles = std::move(solved.profiles);
  std::vector<double> contributions;
  for (const double indicator : energy.indicators) contributions.push_back(indicator * indicator);
  analysis.element_fields.push_back({"indicator", 1, std::move(energy.indicators)});
  std::optional<EstimatedGoal> goal;
  if (solved.goal) goal.emplace(estimate_goal_of(mesh, solved, recovered, analysis));
  analysis.estimate_seconds = watch.lap();
  return {std::move(solved), std::move(recovered), std::move(contributions), std::move(goal)};
}

FieldHessians field_hessians(const FeMesh& mesh, const std::vector<double>& curvature_values,
                             int components, const RecoveredFlux& recovered) {
  if (!curvature_values.empty()) return hessians_of(mesh.mesh, curvature_values, components);
  return hessians_of(mesh.mesh, recovered.vertex_values(), recovered.components(),
                     AcrossInterfaces::jump);
}

/// Of what steers: the solution, or solution and dual weighted by each other's errors.
FieldHessians metric_hessians(const FeMesh& mesh, const Estimated& estimated, bool use_goal) {
  const SolvedModel& solved = estimated.solved;
  FieldHessians hessians = field_hessians(mesh, solved.curvature_values,
                                          solved.curvature_components, estimated.recovered);
  if (!use_goal) return hessians;
  const FieldHessians dual = field_hessians(mesh, solved.goal->dual_curvature_values,
                                            solved.curvature_components, estimated.goal->dual);
  return {goal_hessians(hessians, dual, estimated.goal->estimate)};
}

void require_goal(const AdaptSettings& settings, const Estimated& estimated) {
  if (settings.use_goal && !estimated.goal)
    throw UsageError(
        "the goal is to steer the metric, but the model has none: give it one (Goal), or leave "
        "use_goal off");
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

void add_metric(const FeMesh& mesh, const Estimated& estimated, const AdaptSettings& settings,
                int cycle, Analysis& analysis) {
  Stopwatch watch;
  require_goal(settings, estimated);
  const SteeringError steering = settings.use_goal ? steering_error(*analysis.goal, cycle)
                                                   : steering_error(analysis.error, cycle);
  const int order = estimated.solved.order;
  analysis.target = target_state(settings.target, steering);
  // Errors of a goal are products of two energy errors.
  const double wanted = next_vertices(settings.target, settings.use_goal ? 2 * order : order,
                                      static_cast<double>(mesh.mesh.points.size()), steering);
  Contributions contributions{{}, order};
  if (settings.equidistribute && cycle >= kTrustedCycle)
    contributions.values =
        settings.use_goal ? estimated.goal->estimate.indicators : estimated.contributions;
  StagedMetric metric =
      make_metric(mesh, metric_hessians(mesh, estimated, settings.use_goal), settings.layers,
                  wanted, stage_options(settings, cycle), contributions);
  // On a coarse mesh an a-priori layer metric is known too badly to count its vertices.
  const bool is_counted = !(settings.layer_metric && cycle == 0);
  if (is_counted && std::abs(metric.measure - wanted) > kTargetTolerance * wanted)
    analysis.warnings.push_back(limit_warning(wanted, metric.measure));
  analysis.next_vertices = is_counted ? metric.measure : wanted;
  analysis.metric = std::move(metric.field);
  analysis.stages = std::move(metric.stages);
  analysis.metric_seconds = watch.lap();
}

void require_positive(const Metric& m, Point p) {
  const double det = determinant(m);
  if (m.m11 > 0 && det > 0 && std::isfinite(det)) return;
  throw InputError("the prescribed metric at (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
                   ") is [[" + std::to_string(m.m11) + ", " + std::to_string(m.m12) + "], [., " +
                   std::to_string(m.m22) + "]], expected finite and positive definite");
}

}  // namespace

Analysis analyse_solved(const FeMesh& mesh, SolvedModel solved, const AdaptSettings& settings,
                        int cycle) {
  Analysis analysis;
  add_metric(mesh, estimate(mesh, std::move(solved), analysis), settings, cycle, analysis);
  return analysis;
}

Analyse analyse_model(Model model, Domain domain, AdaptSettings settings) {
  require_one_target(settings.target);
  return [model = std::move(model), domain = std::move(domain), settings = std::move(settings)](
             const Mesh& mesh, int cycle) {
    Analysis analysis;
    const FeMesh fe = curved_fe_mesh(mesh, domain, recorder(analysis));
    SolvedModel solved = solve(fe, model, analysis);
    add_metric(fe, estimate(fe, std::move(solved), analysis), settings, cycle, analysis);
    return analysis;
  };
}

Analyse analyse_prescribed(MetricFunction metric, double gradation, Model model, Domain domain) {
  return [metric = std::move(metric), gradation, model = std::move(model),
          domain = std::move(domain)](const Mesh& mesh, int) {
    Analysis analysis;
    if (model) {
      const FeMesh fe = curved_fe_mesh(mesh, domain, recorder(analysis));
      estimate(fe, solve(fe, model, analysis), analysis);
    }
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
