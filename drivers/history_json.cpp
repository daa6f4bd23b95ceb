#include "drivers/history_json.hpp"

#include <array>

#include <spdlog/fmt/fmt.h>

namespace anisofront {
namespace {

Json histogram_json(const MeshStatistics& s) {
  Json bounds = Json::array();
  for (int i = 1; i < kLengthBins; ++i) bounds.push_back(i / 10.);
  return {{"bounds", bounds}, {"counts", s.histogram}};
}

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json seconds_json(const CycleSeconds& s) {
  return {{"metric", s.metric}, {"front", s.front}, {"enhance", s.enhance},
          {"quads", s.quads},   {"solve", s.solve}, {"estimate", s.estimate}};
}

Json error_json(const CycleError& e) {
  return {{"estimate", optional_json(e.estimate)},
          {"relative_energy", optional_json(e.relative_energy)},
          {"effectivity", optional_json(e.effectivity)}};
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
  cycle["seconds"] = seconds_json(record.seconds);
  cycle["warnings"] = record.warnings;
  return cycle;
}

/// Numbers and lists as such, everything else as text.
Json setting_json(const std::string& value) {
  const Json parsed = Json::parse(value, nullptr, false);
  return parsed.is_discarded() ? Json(value) : parsed;
}

Json variant_json(const VariantHistory& variant) {
  Json settings = Json::object();
  for (const auto& [key, value] : variant.settings) settings[key] = setting_json(value);
  Json cycles = Json::array();
  for (const CycleRecord& record : variant.cycles) cycles.push_back(cycle_json(record));
  return {{"name", variant.name},
          {"settings", settings},
          {"cycles", cycles},
          {"stop_reason", variant.stop_reason}};
}

struct Column {
  const char* name;
  const char* pointer;
};
constexpr std::array<Column, 37> kColumns{
    {{"cycle", "/cycle"},
     {"vertices", "/vertices"},
     {"elements", "/elements"},
     {"edges", "/edges"},
     {"boundary_edges", "/boundary_edges"},
     {"triangles", "/triangles"},
     {"quads", "/quads"},
     {"dofs", "/dofs"},
     {"against", "/quality/against"},
     {"quality_mean", "/quality/mean"},
     {"quality_min", "/quality/min"},
     {"length_min", "/edge_length/min"},
     {"length_max", "/edge_length/max"},
     {"percent_0.5_1.5", "/edge_length/in_0.5_1.5"},
     {"percent_unit_band", "/edge_length/in_unit_band"},
     {"metric_complexity", "/metric_complexity"},
     {"angle_min", "/angle/min"},
     {"angle_max", "/angle/max"},
     {"scaled_jacobian_min", "/scaled_jacobian_min"},
     {"background_quality_mean", "/background/quality/mean"},
     {"background_quality_min", "/background/quality/min"},
     {"background_length_min", "/background/edge_length/min"},
     {"background_length_max", "/background/edge_length/max"},
     {"background_percent_0.5_1.5", "/background/edge_length/in_0.5_1.5"},
     {"background_percent_unit_band", "/background/edge_length/in_unit_band"},
     {"background_metric_complexity", "/background/metric_complexity"},
     {"background_angle_min", "/background/angle/min"},
     {"background_angle_max", "/background/angle/max"},
     {"error_estimate", "/error/estimate"},
     {"error_relative_energy", "/error/relative_energy"},
     {"effectivity", "/error/effectivity"},
     {"seconds_metric", "/seconds/metric"},
     {"seconds_front", "/seconds/front"},
     {"seconds_enhance", "/seconds/enhance"},
     {"seconds_quads", "/seconds/quads"},
     {"seconds_solve", "/seconds/solve"},
     {"seconds_estimate", "/seconds/estimate"}}};

/// RFC 4180: texts in quotes, quotes doubled; unknown values stay empty.
std::string csv_field(const Json& value) {
  if (value.is_null()) return {};
  if (!value.is_string()) return value.dump();
  std::string quoted = "\"";
  for (const char c : value.get<std::string>()) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace

Json statistics_json(const MeshStatistics& s, const std::string& against) {
  return {{"quality", {{"against", against}, {"mean", s.quality_mean}, {"min", s.quality_min}}},
          {"edge_length",
           {{"against", against},
            {"min", s.length_min},
            {"max", s.length_max},
            {"in_0.5_1.5", s.percent_half},
            {"in_unit_band", s.percent_unit},
            {"histogram", histogram_json(s)}}},
          {"angle", {{"against", against}, {"min", s.angle_min}, {"max", s.angle_max}}},
          {"metric_complexity", s.complexity}};
}

Json history_json(const std::string& title, const std::vector<VariantHistory>& variants) {
  Json list = Json::array();
  for (const VariantHistory& variant : variants) list.push_back(variant_json(variant));
  return {{"schema", 1}, {"title", title}, {"variants", list}};
}

std::string history_csv(const Json& history) {
  std::string csv = "variant";
  for (const Column& column : kColumns) csv += fmt::format(",{}", column.name);
  csv += '\n';
  for (const Json& variant : history["variants"])
    for (const Json& cycle : variant["cycles"]) {
      csv += csv_field(variant["name"]);
      for (const Column& column : kColumns)
        csv += "," + csv_field(cycle[Json::json_pointer(column.pointer)]);
      csv += '\n';
    }
  return csv;
}

}  // namespace anisofront
