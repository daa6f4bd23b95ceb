#include "drivers/history/history_json.hpp"

#include <array>

namespace anisofront {
namespace {

/// The number, or null.
Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

constexpr std::array<const char*, 3> kTargetNames{"none", "missed", "reached"};

Json stopped_by_json(const std::optional<StoppedBy>& by) {
  return by ? Json(kStoppedByNames[static_cast<std::size_t>(*by)]) : Json(nullptr);
}

/// Upper bounds 1 / per_unit, 2 / per_unit, ... of the bins that have one.
template <class Counts>
Json histogram_json(const Counts& counts, int bounded, double per_unit) {
  Json bounds = Json::array();
  for (int i = 1; i <= bounded; ++i) bounds.push_back(i / per_unit);
  return {{"bounds", bounds}, {"counts", counts}};
}

Json quality_json(const MeshStatistics& s, const std::string& against) {
  return {{"against", against},
          {"mean", s.quality_mean},
          {"min", s.quality_min},
          {"histogram", histogram_json(s.quality_histogram, kQualityBins, kQualityBins)}};
}

Json seconds_json(const CycleSeconds& s) {
  return {{"metric", s.metric}, {"front", s.front}, {"enhance", s.enhance},
          {"quads", s.quads},   {"solve", s.solve}, {"estimate", s.estimate}};
}

Json error_kind(const CycleError& e) {
  if (e.relative_energy) return "true";
  return e.estimate ? Json("estimate") : Json(nullptr);
}

Json error_json(const CycleError& e) {
  return {{"kind", error_kind(e)},
          {"estimate", optional_json(e.estimate)},
          {"relative_energy", optional_json(e.relative_energy)},
          {"effectivity", optional_json(e.effectivity)}};
}

Json goal_json(const std::optional<GoalRecord>& goal) {
  if (!goal) return nullptr;
  return {{"value", goal->value}, {"error", goal->error}};
}

Json values_json(const std::vector<NamedValue>& values) {
  Json json = Json::object();
  for (const NamedValue& value : values) json[value.name] = value.value;
  return json;
}

Json cycle_json(const CycleRecord& record) {
  const MeshStatistics& s = record.exact ? *record.exact : record.background;
  Json cycle{{"cycle", record.cycle},
             {"vertices", s.vertices},
             {"elements", s.elements},
             {"edges", s.edges},
             {"boundary_edges", s.boundary_edges},
             {"triangles", s.triangles},
             {"quads", s.quads},
             {"dofs", record.dofs}};
  cycle.update(statistics_json(s, record.exact ? "exact" : "background"));
  cycle["scaled_jacobian_min"] = s.scaled_jacobian_min;
  cycle["background"] = statistics_json(record.background, "background");
  cycle["error"] = error_json(record.error);
  cycle["goal"] = goal_json(record.goal);
  cycle["values"] = values_json(record.values);
  cycle["seconds"] = seconds_json(record.seconds);
  cycle["warnings"] = record.warnings;
  return cycle;
}

/// Numbers and lists as such, everything else as text.
Json setting_json(const std::string& value) {
  const Json parsed = Json::parse(value, nullptr, false);
  return parsed.is_discarded() ? Json(value) : parsed;
}

Json settings_json(const std::vector<std::pair<std::string, std::string>>& settings) {
  Json json = Json::object();
  for (const auto& [key, value] : settings) json[key] = setting_json(value);
  return json;
}

Json sizes_json(const std::optional<double>& vertices, const std::optional<double>& dofs) {
  return {{"vertices", optional_json(vertices)}, {"dofs", optional_json(dofs)}};
}

}  // namespace

Json statistics_json(const MeshStatistics& s, const std::string& against) {
  return {{"quality", quality_json(s, against)},
          {"edge_length",
           {{"against", against},
            {"min", s.length_min},
            {"max", s.length_max},
            {"in_0.5_1.5", s.percent_half},
            {"in_unit_band", s.percent_unit},
            {"histogram", histogram_json(s.histogram, kLengthBins - 1, 10)}}},
          {"angle", {{"against", against}, {"min", s.angle_min}, {"max", s.angle_max}}},
          {"metric_complexity", s.complexity},
          {"stretch_max", s.stretch_max}};
}

Json variant_json(const VariantHistory& variant, const std::string& key) {
  Json cycles = Json::array();
  for (const CycleRecord& record : variant.cycles) cycles.push_back(cycle_json(record));
  return {{"name", variant.name},
          {"key", key},
          {"settings", settings_json(variant.settings)},
          {"cycles", cycles},
          {"stop_reason", variant.stop_reason},
          {"stopped_by", stopped_by_json(variant.stopped_by)},
          {"target", kTargetNames.at(static_cast<std::size_t>(variant.target))}};
}

Json comparison_json(const std::vector<ModeComparison>& comparisons) {
  Json list = Json::array();
  for (const ModeComparison& c : comparisons)
    list.push_back({{"settings", settings_json(c.settings)},
                    {"against", c.is_true_error ? "true" : "estimate"},
                    {"error", c.error},
                    {"isotropic", sizes_json(c.isotropic.vertices, c.isotropic.dofs)},
                    {"anisotropic", sizes_json(c.anisotropic.vertices, c.anisotropic.dofs)},
                    {"ratio", sizes_json(size_ratio(c.anisotropic.vertices, c.isotropic.vertices),
                                         size_ratio(c.anisotropic.dofs, c.isotropic.dofs))}});
  return list;
}

Json history_json(const std::string& title, const std::vector<VariantHistory>& variants,
                  const std::vector<std::string>& keys) {
  Json list = Json::array();
  for (std::size_t i = 0; i < variants.size(); ++i)
    list.push_back(variant_json(variants[i], i < keys.size() ? keys[i] : std::string()));
  return {{"schema", 1},
          {"version", ANISOFRONT_VERSION},
          {"title", title},
          {"variants", list},
          {"comparison", comparison_json(compare_modes(variants))}};
}

}  // namespace anisofront
