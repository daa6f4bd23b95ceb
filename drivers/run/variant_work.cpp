#include "drivers/run/variant_work.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/phased_work.hpp"

namespace anisofront {
namespace {

/// Time of making a mesh that does not depend on its size, in vertices (enhancement of thin
/// layers).
constexpr double kVerticesPerMesh = 1000;

/// Vertices of the unit mesh of the metric: 2/sqrt(3) times the integral of sqrt(det M).
double unit_mesh_vertices(const Mesh& mesh, const MetricFunction& metric) {
  MetricField field;
  for (const Point p : mesh.points) field.push_back(metric(p));
  return 2 / std::sqrt(3.) * metric_complexity(mesh, field);
}

double mesh_work(const Study& study) {
  if (study.elements == Elements::triangle) return 0.7;
  const bool is_quick =
      study.quads.effort == QuadEffort::fast || study.quads.method == QuadMethod::paper;
  return is_quick ? 3 : 40;
}

double solve_work(const Study& study) {
  if (study.plate) return 3.5;
  return study.problem && study.problem->order == 2 ? 1.2 : 0.3;
}

/// As errors_against_reference() chooses it.
double reference_vertices(const Study& study, double last_vertices) {
  if (!study.adapt.reference) return 0;
  if (study.adapt.reference->nodes > 0) return study.adapt.reference->nodes;
  return (study.plate || study.problem->order == 2 ? 8 : 16) * last_vertices;
}

}  // namespace

VariantPlan variant_plan(const Study& study, const LoopInput& input,
                         const std::vector<FinishedCycle>& done) {
  VariantPlan plan;
  plan.cycles = input.cycles;
  plan.first_vertices = static_cast<double>(input.initial.points.size());
  plan.vertices = study.adapt.target.vertices.value_or(2 * plan.first_vertices);
  if (input.exact_metric) plan.vertices = unit_mesh_vertices(input.initial, input.exact_metric);
  // At most, see Target::error.
  if (study.adapt.target.error) plan.growth = 2;
  plan.mesh_work = mesh_work(study);
  plan.solve_work = solve_work(study);
  plan.reference_vertices =
      reference_vertices(study, plan.vertices * std::pow(plan.growth, plan.cycles - 1));
  for (const FinishedCycle& cycle : done)
    plan.done_vertices.push_back(static_cast<double>(cycle.mesh.points.size()));
  return plan;
}

VariantWork::VariantWork(VariantPlan plan) : plan_(std::move(plan)) {
  for (const double vertices : plan_.done_vertices) resume_ += plan_.solve_work * vertices;
  cycle_ = static_cast<int>(plan_.done_vertices.size());
  vertices_ = cycle_ == 0 ? plan_.first_vertices : plan_.vertices;
  expected_ = resume_ + later_work(vertices_);
}

double VariantWork::cycle_work(int cycle, double vertices) const {
  const double meshing = cycle == 0 ? 0 : plan_.mesh_work * (vertices + kVerticesPerMesh);
  return meshing + plan_.solve_work * vertices;
}

/// From the cycle at work on, whose mesh has so many vertices.
double VariantWork::later_work(double vertices) const {
  double work = 0;
  for (int cycle = cycle_; cycle <= plan_.cycles; ++cycle) {
    work += cycle_work(cycle, vertices);
    vertices = cycle == 0 ? plan_.vertices : plan_.growth * vertices;
  }
  // Solved twice: with all sources, and for the difference to the solutions of the cycles.
  return work + plan_.reference_vertices * (plan_.mesh_work + 2 * plan_.solve_work);
}

/// Work done in the cycle, or for the reference, when a library reports from within.
double VariantWork::within_stage(std::string_view phase, double fraction) const {
  const double vertices = is_reference_ ? plan_.reference_vertices : vertices_;
  const double solving = (is_reference_ ? 2 : 1) * plan_.solve_work * vertices;
  const double meshing =
      is_reference_ ? plan_.mesh_work * vertices : cycle_work(cycle_, vertices_) - solving;
  // Quadrilaterals report their passes again and again.
  static const std::vector<Phase> kMeshing{{"front", 0, 0.2},
                                           {"enhance", 0.2, 1},
                                           {"quads", 0.5, 0.8},
                                           {"solve", 1, 1},
                                           {"linear system", 1, 1}};
  static const std::vector<Phase> kSolving{{"linear system", 0.2, 0.8}};
  return meshing * share_done(kMeshing, phase, fraction) +
         solving * share_done(kSolving, phase, fraction);
}

void VariantWork::report(std::string_view phase, double fraction) {
  if (phase == "resume") {
    part_ = fraction * resume_;
  } else if (phase == "cycles" && resume_ > 0) {
    finished_ += resume_;
    expected_ -= resume_;
    resume_ = part_ = 0;
  } else if (phase == "reference") {
    is_reference_ = true;
    part_ = 0;
  } else if (resume_ == 0) {
    part_ = std::max(part_, within_stage(phase, fraction));
  }
}

void VariantWork::finish_cycle(double vertices, double next) {
  finished_ += cycle_work(cycle_, vertices);
  part_ = 0;
  vertices_ = next > 0 ? next : cycle_ == 0 ? plan_.vertices : vertices;
  // What is told about the next mesh is better known than what was planned.
  plan_.vertices = vertices_;
  ++cycle_;
  expected_ = later_work(vertices_);
}

std::string VariantWork::stage() const {
  if (resume_ > 0) return "earlier cycles";
  if (is_reference_) return "true errors";
  return fmt::format("cycle {} of {}", std::min(cycle_, plan_.cycles), plan_.cycles);
}

void VariantWork::finish() { part_ = expected_ = 0; }

}  // namespace anisofront
