#include "drivers/report/result_tables.hpp"

#include <algorithm>

#include "drivers/history/history_csv.hpp"
#include "drivers/report/cell_text.hpp"

namespace anisofront {
namespace {

std::string significant(const Json& value) { return number_cell(value, "{:.6g}"); }

/// The last cycle of a variant, or null.
Json last_cycle(const Json& variant) {
  return variant["cycles"].empty() ? Json() : variant["cycles"].back();
}

bool is_prescribed(const Json& variant) {
  const Json last = last_cycle(variant);
  return !last.is_null() && last["quality"]["against"] == "exact";
}

bool has_problem(const Json& variant) {
  const Json last = last_cycle(variant);
  return last.is_null() || last["dofs"] != 0;
}

void add_row(TextTable& table, std::vector<std::string> cells) {
  table.rows.push_back(std::move(cells));
  table.is_reference.push_back(false);
}

std::vector<std::string> result_cells(const Json& variant) {
  const Json last = last_cycle(variant);
  if (last.is_null())
    return {variant["name"], "-", "-", "-", "-", "-", "-", "-", variant["stop_reason"]};
  const Json& error = last["error"];
  return {variant["name"],
          std::to_string(last["cycle"].get<int>()),
          std::to_string(last["vertices"].get<int>()),
          std::to_string(last["dofs"].get<int>()),
          number_cell(error["estimate"], "{:.3e}"),
          number_cell(error["relative_energy"], "{:.3e}"),
          number_cell(error["effectivity"], "{:.3f}"),
          percent_cell(last["edge_length"]["in_unit_band"], 1),
          variant["stop_reason"]};
}

/// Names of the values on the last meshes, in the order in which they first appear.
std::vector<std::string> value_names(const Json& history) {
  std::vector<std::string> names;
  for (const Json& variant : history["variants"]) {
    const Json last = last_cycle(variant);
    if (last.is_null()) continue;
    for (const auto& [name, value] : last["values"].items())
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

bool has_goal(const Json& history) {
  return std::any_of(history["variants"].begin(), history["variants"].end(), [](const Json& v) {
    const Json last = last_cycle(v);
    return !last.is_null() && last["goal"].is_object();
  });
}

/// Whether a setting of one comparison tells it from another. Meshes of quadrilaterals alone have
/// settings for their making, which triangles just lack.
bool tells_from(const std::string& key, const Json& value, const Json& other) {
  const Json& settings = other["settings"];
  if (!settings.contains(key)) return !key.starts_with("mesh.quad_");
  return settings[key] != value;
}

/// The settings that differ between the comparisons, without the names of their tables.
std::string distinguishing_settings(const Json& comparison, const Json& all) {
  Json settings = Json::object();
  for (const auto& [key, value] : comparison["settings"].items())
    for (const Json& other : all)
      if (tells_from(key, value, other)) settings[key.substr(key.rfind('.') + 1)] = value;
  return settings.empty() ? "all" : settings_text(settings);
}

std::vector<std::string> comparison_cells(const Json& comparison, const Json& all) {
  const auto size = [&](const char* mode, const char* what) {
    return number_cell(comparison[mode][what], "{:.0f}");
  };
  return {distinguishing_settings(comparison, all),
          comparison["against"],
          number_cell(comparison["error"], "{:.3e}"),
          size("isotropic", "vertices"),
          size("anisotropic", "vertices"),
          number_cell(comparison["ratio"]["vertices"], "{:.4f}"),
          size("isotropic", "dofs"),
          size("anisotropic", "dofs"),
          number_cell(comparison["ratio"]["dofs"], "{:.4f}")};
}

/// A history with those variants that have statistics against a formula.
Json prescribed_only(const Json& history) {
  Json kept = history;
  kept["variants"] = Json::array();
  for (const Json& variant : history["variants"])
    if (is_prescribed(variant)) kept["variants"].push_back(variant);
  return kept;
}

}  // namespace

TextTable result_table(const Json& history) {
  TextTable table;
  table.header = {"variant",    "cycles",      "vertices",    "dofs",   "estimate",
                  "true error", "effectivity", "unit band %", "stopped"};
  table.ends_in_text = true;
  for (const Json& variant : history["variants"])
    if (has_problem(variant)) add_row(table, result_cells(variant));
  return table;
}

TextTable value_table(const Json& history) {
  const std::vector<std::string> names = value_names(history);
  const bool with_goal = has_goal(history);
  TextTable table;
  table.header = {"variant"};
  if (with_goal) table.header.insert(table.header.end(), {"goal", "goal error"});
  table.header.insert(table.header.end(), names.begin(), names.end());
  if (table.header.size() == 1) return table;
  for (const Json& variant : history["variants"]) {
    const Json last = last_cycle(variant);
    if (last.is_null()) continue;
    std::vector<std::string> cells{variant["name"]};
    const Json goal = last["goal"].is_object() ? last["goal"] : Json::object();
    if (with_goal)
      cells.insert(cells.end(), {significant(goal.value("value", Json())),
                                 number_cell(goal.value("error", Json()), "{:.2e}")});
    for (const std::string& name : names)
      cells.push_back(significant(last["values"].value(name, Json())));
    add_row(table, std::move(cells));
  }
  return table;
}

TextTable comparison_table(const Json& history) {
  TextTable table;
  table.header = {"at equal error", "errors",   "error",      "iso vertices", "aniso vertices",
                  "ratio",          "iso dofs", "aniso dofs", "ratio"};
  for (const Json& comparison : history["comparison"])
    add_row(table, comparison_cells(comparison, history["comparison"]));
  return table;
}

std::string console_summary(const Json& history) {
  std::string text;
  for (const TextTable& table : {summary_table(prescribed_only(history)), result_table(history),
                                 value_table(history), comparison_table(history)})
    if (!table.rows.empty()) text += (text.empty() ? "" : "\n") + as_text(table);
  return text;
}

}  // namespace anisofront
