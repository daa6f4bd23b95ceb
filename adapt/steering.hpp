#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapt/history.hpp"

namespace anisofront {

/// What a study aims at. Exactly one is set.
struct Target {
  std::optional<double> vertices;  ///< of every mesh from cycle 1 on
  /// Relative energy error to reach. The true error steers where an exact solution is known, the
  /// estimate elsewhere (believed from cycle 2 on). Vertices follow from the order of the elements
  /// and at most double in a cycle.
  std::optional<double> error;
};

/// Throws UsageError unless exactly one target is set, and for values that are not positive.
void require_one_target(const Target& target);

/// Estimates are believed from this cycle on: on a mesh that misses a layer they are far too small
/// (0.03 of the error for a layer 60 times thinner than the initial cells, 0.7 in cycle 2).
inline constexpr int kTrustedCycle = 2;

/// The error that the target speaks of, and whether it may end the loop or shrink the mesh.
struct SteeringError {
  double relative = 0;
  bool trusted = false;
};
SteeringError steering_error(const CycleError& error, int cycle);
/// Of a quantity of interest, relative to its value.
SteeringError steering_error(const GoalRecord& goal, int cycle);

/// Vertices of the next mesh; the error falls like vertices^(-order / 2).
double next_vertices(const Target& target, int order, double vertices, const SteeringError& error);

TargetState target_state(const Target& target, const SteeringError& error);

/// Ends of the loop other than target and number of cycles.
struct StopRules {
  /// The estimate changed by less than this share in each of the last two cycles although the
  /// number of vertices is that of the target; 0: off.
  double plateau = 0;
  Index max_vertices = 0;  ///< 0: no limit
  double max_seconds = 0;  ///< CPU seconds of all cycles; 0: no limit
};

struct StopReason {
  StoppedBy by = StoppedBy::cycles;
  std::string words;
};
/// The reason when a rule asks to stop after the last of these cycles; the next mesh would have
/// about `next` vertices.
std::optional<StopReason> reason_to_stop(const StopRules& rules,
                                         const std::vector<CycleRecord>& cycles, double next);

}  // namespace anisofront
