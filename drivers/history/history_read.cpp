#include <cmath>
#include <limits>

#include "drivers/history/history_json.hpp"

namespace anisofront {
namespace {

/// JSON has no word for numbers that are not finite: they were written as null.
double real(const Json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

std::optional<double> optional_real(const Json& value) {
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

void read_counts(const Json& cycle, MeshStatistics& s) {
  s.vertices = cycle.at("vertices");
  s.elements = cycle.at("elements");
  s.edges = cycle.at("edges");
  s.boundary_edges = cycle.at("boundary_edges");
  s.triangles = cycle.at("triangles");
  s.quads = cycle.at("quads");
  s.scaled_jacobian_min = real(cycle.at("scaled_jacobian_min"));
}

/// `json`: what statistics_json() has made, within `cycle`.
MeshStatistics statistics(const Json& cycle, const Json& json) {
  MeshStatistics s;
  read_counts(cycle, s);
  const Json& quality = json.at("quality");
  s.quality_mean = real(quality.at("mean"));
  s.quality_min = real(quality.at("min"));
  // Records of program 0.1 have none.
  if (quality.contains("histogram")) s.quality_histogram = quality["histogram"].at("counts");
  const Json& length = json.at("edge_length");
  s.length_min = real(length.at("min"));
  s.length_max = real(length.at("max"));
  s.percent_half = real(length.at("in_0.5_1.5"));
  s.percent_unit = real(length.at("in_unit_band"));
  s.histogram = length.at("histogram").at("counts");
  s.angle_min = real(json.at("angle").at("min"));
  s.angle_max = real(json.at("angle").at("max"));
  s.complexity = real(json.at("metric_complexity"));
  s.stretch_max = real(json.at("stretch_max"));
  return s;
}

CycleSeconds seconds(const Json& json) {
  return {real(json.at("metric")), real(json.at("front")), real(json.at("enhance")),
          real(json.at("quads")),  real(json.at("solve")), real(json.at("estimate"))};
}

CycleError error(const Json& json) {
  return {optional_real(json.at("estimate")), optional_real(json.at("relative_energy")),
          optional_real(json.at("effectivity"))};
}

CycleRecord cycle_record(const Json& json) {
  CycleRecord record;
  record.cycle = json.at("cycle");
  record.dofs = json.at("dofs");
  record.background = statistics(json, json.at("background"));
  if (json.at("quality").at("against") == "exact") record.exact = statistics(json, json);
  record.error = error(json.at("error"));
  const Json& goal = json.at("goal");
  if (!goal.is_null()) record.goal = GoalRecord{real(goal.at("value")), real(goal.at("error"))};
  for (const auto& [name, value] : json.at("values").items())
    record.values.push_back({name, real(value)});
  record.seconds = seconds(json.at("seconds"));
  record.warnings = json.at("warnings").get<std::vector<std::string>>();
  return record;
}

TargetState target_state(const std::string& name) {
  if (name == "reached") return TargetState::reached;
  return name == "missed" ? TargetState::missed : TargetState::none;
}

/// Records of program 0.1 have none.
std::optional<StoppedBy> stopped_by(const Json& variant) {
  const Json name = variant.value("stopped_by", Json());
  for (std::size_t i = 0; i < kStoppedByNames.size(); ++i)
    if (name == kStoppedByNames[i]) return static_cast<StoppedBy>(i);
  return {};
}

}  // namespace

VariantHistory variant_history(const Json& variant) {
  VariantHistory history;
  history.name = variant.at("name");
  for (const Json& cycle : variant.at("cycles")) history.cycles.push_back(cycle_record(cycle));
  history.stop_reason = variant.at("stop_reason");
  history.target = target_state(variant.at("target"));
  history.stopped_by = stopped_by(variant);
  return history;
}

}  // namespace anisofront
