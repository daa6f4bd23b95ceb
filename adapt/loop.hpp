#pragma once

#include <functional>
#include <span>

#include "adapt/analysis.hpp"
#include "adapt/steering.hpp"
#include "mesher/generate.hpp"

namespace anisofront {

/// What makes the next mesh: generate() or, in comparisons and tests, another mesher.
using MakeMesh = std::function<GenerateResult(const Domain&, const Mesh&, const MetricField&,
                                              const GenerateOptions&, const Monitor&)>;

/// Relative energy errors of the solutions on the meshes of all cycles, where no exact solution is
/// known (see errors_against_reference()).
using MeasureErrors = std::function<std::vector<double>(std::span<const Mesh> meshes)>;

/// A cycle of an earlier run that was interrupted.
struct FinishedCycle {
  CycleRecord record;
  Mesh mesh;
};

struct LoopInput {
  Domain domain;
  Mesh initial;  ///< attached to the domain
  Analyse analyse;
  /// The exact metric, when it is prescribed; empty otherwise.
  MetricFunction exact_metric;
  int cycles = 5;
  StopRules stop;
  GenerateOptions generate;
  MakeMesh make_mesh = anisofront::generate;
  MeasureErrors measure_errors;  ///< called after the last cycle; empty: errors stay as they are
  /// Cycles 0, 1, ... to go on from. They are analysed again (the analysis may remember earlier
  /// solutions), which gives what it gave before, and not passed to `finished` again.
  std::vector<FinishedCycle> done;
  /// Called with each finished cycle (the initial mesh included): write files, draw progress.
  std::function<void(const CycleRecord&, const Mesh&, const Analysis&)> finished;
  /// Called with each cycle of `done` when it has been analysed again.
  std::function<void(const CycleRecord&, const Mesh&, const Analysis&)> replayed;
};

/// Cycles 1..n: analyse the mesh of cycle k-1, generate mesh k; the last mesh is analysed too.
/// Ends early when an analysis has reached its target or a stop rule holds; the reason is recorded.
/// Statistics of cycle 0, which has no background, are taken against its own analysis
/// metric. Warnings of an analysis are recorded and passed on to the monitor.
/// Throws what generate() and analyse throw; cycles that `finished` has seen stay valid.
VariantHistory adapt_loop(const LoopInput& input, const Monitor& monitor = {});

}  // namespace anisofront
