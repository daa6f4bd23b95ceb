#pragma once

#include <functional>
#include <string>
#include <vector>

#include "adapt/history.hpp"
#include "adapt/metric_stages.hpp"
#include "adapt/profile.hpp"

namespace anisofront {

/// What one analysis of a mesh yields: the metric for the next mesh, and what is to be recorded.
struct Analysis {
  MetricField metric;  ///< per vertex of the mesh
  /// Vertices that the next mesh will have, about; 0: not known.
  double next_vertices = 0;
  Index dofs = 0;
  CycleError error;
  std::optional<GoalRecord> goal;
  std::vector<NamedValue> values;
  /// Without the true error and the profiles, which no adaptive loop needs.
  double solve_seconds = 0, estimate_seconds = 0, metric_seconds = 0;
  /// Named fields for output (solution first), `components` values per vertex or element.
  struct Field {
    std::string name;
    int components = 1;
    std::vector<double> values;
  };
  std::vector<Field> vertex_fields;
  std::vector<Field> element_fields;
  std::vector<Profile> profiles;    ///< of the model
  std::vector<MetricStage> stages;  ///< when asked for
  /// reached: the loop stops after this mesh.
  TargetState target = TargetState::none;
  std::vector<std::string> warnings;
};

/// solve + estimate + metric on one mesh: either a boundary value problem or a prescribed metric
/// sampled at the vertices. `cycle` is the number of the mesh (0: the initial one).
using Analyse = std::function<Analysis(const Mesh& mesh, int cycle)>;

}  // namespace anisofront
