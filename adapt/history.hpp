#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesher/metric/statistics.hpp"

namespace anisofront {

/// Where a mesh stands with respect to the target error of the study.
enum class TargetState { none, missed, reached };

/// What ended a loop: all its cycles are done, the target error is reached, a stop rule
/// (StopRules), or from outside a signal or an error.
enum class StoppedBy { cycles, target, plateau, budget, interrupted, failed };

/// CPU seconds of one cycle.
struct CycleSeconds {
  double metric = 0, front = 0, enhance = 0, quads = 0, solve = 0, estimate = 0;
};

/// Errors of the solution on the mesh of this cycle; what is unknown is empty.
struct CycleError {
  std::optional<double> estimate;
  std::optional<double> relative_energy;  ///< true error / true energy norm, from an exact solution
  std::optional<double> effectivity;
};

/// The quantity of interest J and its estimated error J(u) - J(u_h).
struct GoalRecord {
  double value = 0;
  double error = 0;
};

/// A number of the solution that users watch: the largest deflection, the value at a place.
struct NamedValue {
  std::string name;
  double value = 0;
};

/// One row of the history: the mesh that a cycle ended with. Cycle 0 is the initial mesh.
struct CycleRecord {
  int cycle = 0;
  Index dofs = 0;
  /// Against the metric interpolated from the mesh that served as background.
  MeshStatistics background;
  /// Against the exact formula of a prescribed metric.
  std::optional<MeshStatistics> exact;
  CycleError error;
  std::optional<GoalRecord> goal;
  std::vector<NamedValue> values;
  CycleSeconds seconds;
  std::vector<std::string> warnings;
};

struct VariantHistory {
  std::string name;
  std::vector<std::pair<std::string, std::string>> settings;  ///< key, value as in the study file
  std::vector<CycleRecord> cycles;
  std::string stop_reason;  ///< in words
  /// State of the last mesh; `missed` is exit code 1 of the program.
  TargetState target = TargetState::none;
  std::optional<StoppedBy> stopped_by = {};  ///< empty while cycles are to follow
};

}  // namespace anisofront
