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
  cycle.record.goal = analysis.goal;
  cycle.record.values = analysis.values;
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

/// The last finished cycle of an earlier run as it was when it had just been analysed.
Cycle resumed_cycle(const LoopInput& input, const Monitor& monitor) {
  Cycle cycle;
  for (const FinishedCycle& done : input.done) {
    monitor.report("resume", static_cast<double>(done.record.cycle) / input.cycles);
    cycle.mesh = done.mesh;
    cycle.record = done.record;
    cycle.analysis = input.analyse(cycle.mesh, cycle.record.cycle);
    if (input.replayed) input.replayed(cycle.record, cycle.mesh, cycle.analysis);
  }
  return cycle;
}

StopReason end_of_cycles(TargetState target, int cycles) {
  const std::string after = " after " + std::to_string(cycles) + " cycles";
  if (target == TargetState::reached) return {StoppedBy::target, "target error reached" + after};
  if (target == TargetState::missed) return {StoppedBy::cycles, "target error missed" + after};
  return {StoppedBy::cycles, "finished" + after};
}

/// The reason to stop after the last recorded cycle, if there is one.
std::optional<StopReason> stop_reason(const LoopInput& input, const VariantHistory& history,
                                      const Cycle& last) {
  if (last.record.cycle >= input.cycles || history.target == TargetState::reached)
    return end_of_cycles(history.target, last.record.cycle);
  return reason_to_stop(input.stop, history.cycles, last.analysis.next_vertices);
}

void measure_errors(const LoopInput& input, const std::vector<Mesh>& meshes,
                    VariantHistory& history) {
  const std::vector<double> errors = input.measure_errors(meshes);
  for (std::size_t k = 0; k < errors.size(); ++k) {
    CycleError& error = history.cycles[k].error;
    error.relative_energy = errors[k];
    if (error.estimate) error.effectivity = *error.estimate / errors[k];
  }
}

}  // namespace

VariantHistory adapt_loop(const LoopInput& input, const Monitor& monitor) {
  VariantHistory history;
  std::vector<Mesh> meshes;
  for (const FinishedCycle& done : input.done) {
    history.cycles.push_back(done.record);
    meshes.push_back(done.mesh);
  }
  Cycle cycle = input.done.empty() ? initial_cycle(input, monitor) : resumed_cycle(input, monitor);
  for (bool is_new = input.done.empty();; is_new = true) {
    if (is_new) {
      history.cycles.push_back(cycle.record);
      meshes.push_back(cycle.mesh);
      if (input.finished) input.finished(cycle.record, cycle.mesh, cycle.analysis);
    }
    history.target = cycle.analysis.target;
    if (const auto reason = stop_reason(input, history, cycle)) {
      history.stop_reason = reason->words;
      history.stopped_by = reason->by;
      break;
    }
    monitor.report("cycles", static_cast<double>(cycle.record.cycle) / input.cycles);
    cycle = next_cycle(input, cycle, monitor);
  }
  if (input.measure_errors) {
    monitor.report("reference", 1);
    measure_errors(input, meshes, history);
  }
  return history;
}

}  // namespace anisofront
