#include "adapt/loop.hpp"

#include <utility>

#include "mesher/background/background_mesh.hpp"

namespace anisofront {
namespace {

/// A mesh with what was found out about it.
struct Cycle {
  Mesh mesh;
  Analysis analysis;
  CycleRecord record;
};

/// Analyses the mesh and completes the record with what the analysis knows.
void analyse(const LoopInput& input, Cycle& cycle, const Monitor& monitor) {
  cycle.analysis = input.analyse(cycle.mesh, cycle.record.cycle);
  const Analysis& analysis = cycle.analysis;
  cycle.record.dofs = analysis.dofs;
  cycle.record.error = analysis.error;
  cycle.record.seconds.solve = analysis.solve_seconds;
  cycle.record.seconds.estimate = analysis.estimate_seconds;
  cycle.record.seconds.metric += analysis.metric_seconds;
  cycle.record.warnings = analysis.warnings;
  for (const std::string& warning : analysis.warnings) monitor.warning(warning);
}

void add_statistics(const LoopInput& input, const Mesh& background, const MetricField& field,
                    Cycle& cycle) {
  cycle.record.background = mesh_statistics(
      cycle.mesh, background_metric(background, field, input.generate.interpolation));
  if (input.exact_metric) cycle.record.exact = mesh_statistics(cycle.mesh, input.exact_metric);
}

Cycle initial_cycle(const LoopInput& input, const Monitor& monitor) {
  Cycle cycle;
  cycle.mesh = input.initial;
  analyse(input, cycle, monitor);
  add_statistics(input, cycle.mesh, cycle.analysis.metric, cycle);
  return cycle;
}

Cycle next_cycle(const LoopInput& input, const Cycle& last, const Monitor& monitor) {
  GenerateResult made =
      input.make_mesh(input.domain, last.mesh, last.analysis.metric, input.generate, monitor);
  Cycle cycle;
  cycle.mesh = std::move(made.mesh);
  cycle.record.cycle = last.record.cycle + 1;
  cycle.record.seconds.metric = made.seconds.background;
  cycle.record.seconds.front = made.seconds.boundary + made.seconds.front;
  cycle.record.seconds.enhance = made.seconds.enhance + made.seconds.verify;
  cycle.record.seconds.quads = made.seconds.quads;
  add_statistics(input, last.mesh, last.analysis.metric, cycle);
  analyse(input, cycle, monitor);
  return cycle;
}

std::string stop_reason(TargetState target, int cycles) {
  const std::string after = " after " + std::to_string(cycles) + " cycles";
  if (target == TargetState::reached) return "target error reached" + after;
  if (target == TargetState::missed) return "target error missed" + after;
  return "finished" + after;
}

}  // namespace

VariantHistory adapt_loop(const LoopInput& input, const Monitor& monitor) {
  VariantHistory history;
  Cycle cycle = initial_cycle(input, monitor);
  for (;;) {
    history.cycles.push_back(cycle.record);
    if (input.finished) input.finished(cycle.record, cycle.mesh, cycle.analysis);
    history.target = cycle.analysis.target;
    if (cycle.record.cycle >= input.cycles || history.target == TargetState::reached) break;
    monitor.report("cycles", static_cast<double>(cycle.record.cycle) / input.cycles);
    cycle = next_cycle(input, cycle, monitor);
  }
  history.stop_reason = stop_reason(history.target, cycle.record.cycle);
  return history;
}

}  // namespace anisofront
