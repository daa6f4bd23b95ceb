#pragma once

#include <functional>

#include "adapt/history.hpp"
#include "mesher/generate.hpp"

namespace anisofront {

/// What one analysis of a mesh yields: the metric for the next mesh, and what is to be recorded.
struct Analysis {
  MetricField metric;  ///< per vertex of the mesh; empty when not asked for
  Index dofs = 0;
  CycleError error;
  double solve_seconds = 0, estimate_seconds = 0, metric_seconds = 0;
  /// Named per-vertex fields for output (solution first), `components` values per vertex.
  struct Field {
    std::string name;
    int components = 1;
    std::vector<double> values;
  };
  std::vector<Field> vertex_fields;
  std::vector<Field> element_fields;
  /// reached: the loop stops after this mesh.
  TargetState target = TargetState::none;
  std::vector<std::string> warnings;
};

/// solve + estimate + metric on one mesh: either a boundary value problem or a prescribed metric
/// sampled at the vertices. `cycle` is the number of the mesh (0: the initial one).
using Analyse = std::function<Analysis(const Mesh& mesh, int cycle)>;

/// What makes the next mesh: generate() or, in comparisons and tests, another mesher.
using MakeMesh = std::function<GenerateResult(const Domain&, const Mesh&, const MetricField&,
                                              const GenerateOptions&, const Monitor&)>;

struct LoopInput {
  Domain domain;
  Mesh initial;  ///< attached to the domain
  Analyse analyse;
  /// The exact metric, when it is prescribed; empty otherwise.
  MetricFunction exact_metric;
  int cycles = 5;
  GenerateOptions generate;
  MakeMesh make_mesh = anisofront::generate;
  /// Called with each finished cycle (the initial mesh included): write files, draw progress.
  std::function<void(const CycleRecord&, const Mesh&, const Analysis&)> finished;
};

/// Cycles 1..n: analyse the mesh of cycle k-1, generate mesh k; the last mesh is analysed too.
/// Ends early when an analysis has reached its target. Statistics of cycle 0, which has no
/// background, are taken against its own analysis metric. Warnings of an analysis are recorded and
/// passed on to the monitor.
/// Throws what generate() and analyse throw; cycles that `finished` has seen stay valid.
VariantHistory adapt_loop(const LoopInput& input, const Monitor& monitor = {});

}  // namespace anisofront
