#include "adapt/steering.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

/// The first meshes do not see the layers and their error says little about the vertices needed:
/// the number changes by at most this factor a cycle. The error aimed at lies a little below the
/// target.
constexpr double kMaxGrowth = 2;
constexpr double kTargetMargin = 0.95;
/// Numbers of vertices that differ by less count as the same.
constexpr double kSameSize = 0.05;

void require_positive(const std::optional<double>& value, const char* name) {
  if (value && !(*value > 0 && std::isfinite(*value)))
    throw UsageError(std::string("adapt.target: ") + name + " is " + std::to_string(*value) +
                     ", expected a positive number");
}

double seconds_of(const CycleSeconds& s) {
  return s.metric + s.front + s.enhance + s.quads + s.solve + s.estimate;
}

bool is_plateau(double share, const std::vector<CycleRecord>& cycles) {
  if (share <= 0 || cycles.size() < 3) return false;
  for (std::size_t k = cycles.size() - 2; k < cycles.size(); ++k) {
    const CycleRecord &before = cycles[k - 1], &now = cycles[k];
    if (!before.error.estimate || !now.error.estimate) return false;
    const double change = std::abs(*now.error.estimate / *before.error.estimate - 1);
    const double growth = std::abs(static_cast<double>(now.background.vertices) /
                                       static_cast<double>(before.background.vertices) -
                                   1);
    if (change > share || growth > kSameSize) return false;
  }
  return true;
}

}  // namespace

void require_one_target(const Target& target) {
  if (target.vertices.has_value() == target.error.has_value())
    throw UsageError("adapt.target: expected exactly one of error and nodes");
  require_positive(target.vertices, "the number of nodes");
  require_positive(target.error, "the error");
}

SteeringError steering_error(const CycleError& error, int cycle) {
  if (error.relative_energy) return {*error.relative_energy, true};
  return {error.estimate.value_or(0), cycle >= kTrustedCycle};
}

SteeringError steering_error(const GoalRecord& goal, int cycle) {
  return {std::abs(goal.error / goal.value), cycle >= kTrustedCycle};
}

double next_vertices(const Target& target, int order, double vertices, const SteeringError& error) {
  if (target.vertices) return *target.vertices;
  const double ratio = error.relative / (kTargetMargin * *target.error);
  const double least = error.trusted ? 1 / kMaxGrowth : 1;
  return vertices * std::clamp(std::pow(ratio, 2. / order), least, kMaxGrowth);
}

TargetState target_state(const Target& target, const SteeringError& error) {
  if (!target.error) return TargetState::none;
  return error.trusted && error.relative <= *target.error ? TargetState::reached
                                                          : TargetState::missed;
}

std::optional<StopReason> reason_to_stop(const StopRules& rules,
                                         const std::vector<CycleRecord>& cycles, double next) {
  const std::string after = " after " + std::to_string(cycles.back().cycle) + " cycles";
  if (is_plateau(rules.plateau, cycles))
    return StopReason{StoppedBy::plateau,
                      "plateau" + after + ": the estimate changed by less than " +
                          std::to_string(std::lround(100 * rules.plateau)) +
                          " % in two cycles at " +
                          std::to_string(cycles.back().background.vertices) + " vertices"};
  if (rules.max_vertices > 0 && next > static_cast<double>(rules.max_vertices))
    return StopReason{StoppedBy::budget, "budget reached" + after +
                                             ": the next mesh would have about " +
                                             std::to_string(std::llround(next)) + " vertices, " +
                                             std::to_string(rules.max_vertices) + " are allowed"};
  double seconds = 0;
  for (const CycleRecord& cycle : cycles) seconds += seconds_of(cycle.seconds);
  if (rules.max_seconds > 0 && seconds >= rules.max_seconds)
    return StopReason{StoppedBy::budget, "budget reached" + after + ": " +
                                             std::to_string(std::llround(seconds)) + " of " +
                                             std::to_string(std::llround(rules.max_seconds)) +
                                             " seconds are used"};
  return {};
}

}  // namespace anisofront
