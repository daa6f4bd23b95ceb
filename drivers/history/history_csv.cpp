#include "drivers/history/history_csv.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "drivers/base/text.hpp"

namespace anisofront {
namespace {

struct Column {
  const char* name;
  const char* pointer;
};

constexpr std::array<Column, 42> kCycleColumns{
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
     {"seconds_estimate", "/seconds/estimate"},
     {"stretch_max", "/stretch_max"},
     {"background_stretch_max", "/background/stretch_max"},
     {"error_kind", "/error/kind"},
     {"goal_value", "/goal/value"},
     {"goal_error", "/goal/error"}}};

constexpr std::array<Column, 8> kComparisonColumns{
    {{"against", "/against"},
     {"error", "/error"},
     {"isotropic_vertices", "/isotropic/vertices"},
     {"anisotropic_vertices", "/anisotropic/vertices"},
     {"vertex_ratio", "/ratio/vertices"},
     {"isotropic_dofs", "/isotropic/dofs"},
     {"anisotropic_dofs", "/anisotropic/dofs"},
     {"dof_ratio", "/ratio/dofs"}}};

/// RFC 4180: texts in quotes, quotes doubled; unknown values stay empty.
std::string csv_field(const Json& value) {
  if (value.is_null()) return {};
  if (!value.is_string()) return value.dump();
  std::string quoted = "\"";
  for (const char c : value.get<std::string>()) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string titles(std::span<const Column> columns) {
  std::string text;
  for (const Column& column : columns) text += std::string(",") + column.name;
  return text;
}

/// One field per column, each after a comma.
std::string fields(const Json& row, std::span<const Column> columns) {
  std::string text;
  for (const Column& column : columns) {
    const Json::json_pointer pointer(column.pointer);
    text += "," + (row.contains(pointer) ? csv_field(row[pointer]) : std::string());
  }
  return text;
}

/// Names of all values, in the order in which they first appear.
std::vector<std::string> value_names(const Json& history) {
  std::vector<std::string> names;
  for (const Json& variant : history["variants"])
    for (const Json& cycle : variant["cycles"])
      for (const auto& [name, value] : cycle["values"].items())
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

}  // namespace

std::string history_csv(const Json& history) {
  const std::vector<std::string> values = value_names(history);
  std::string csv = "variant" + titles(kCycleColumns);
  for (const std::string& name : values) csv += "," + csv_field("value " + name);
  csv += '\n';
  for (const Json& variant : history["variants"])
    for (const Json& cycle : variant["cycles"]) {
      csv += csv_field(variant["name"]) + fields(cycle, kCycleColumns);
      for (const std::string& name : values)
        csv += "," + csv_field(cycle["values"].value(name, Json()));
      csv += '\n';
    }
  return csv;
}

std::string comparison_csv(const Json& history) {
  std::string csv = "settings" + titles(kComparisonColumns) + "\n";
  for (const Json& comparison : history["comparison"])
    csv += csv_field(settings_text(comparison["settings"])) +
           fields(comparison, kComparisonColumns) + "\n";
  return csv;
}

std::string settings_text(const Json& settings) {
  std::vector<std::string> texts;
  for (const auto& [key, value] : settings.items())
    texts.push_back(key + " = " + (value.is_string() ? value.get<std::string>() : value.dump()));
  return joined(texts);
}

}  // namespace anisofront
