#include "drivers/report/summary.hpp"

#include <spdlog/fmt/fmt.h>

#include "drivers/report/cell_text.hpp"
#include "drivers/study/paper_table.hpp"

namespace anisofront {
namespace {

const std::vector<std::string> kColumns{"against", "type",        "NN",     "NE",        "ND",
                                        "NB",      "mean",        "min",    "0.5-1.5 %", "l_min",
                                        "l_max",   "unit band %", "angles", "min sJ",    "error"};

std::string count(const Json& value) { return std::to_string(value.get<std::int64_t>()); }

std::string error_text(const Json& error) {
  if (error["relative_energy"].is_number()) return number_cell(error["relative_energy"], "{:.3e}");
  if (error["estimate"].is_number()) return "~" + number_cell(error["estimate"], "{:.3e}");
  return "-";
}

/// "T", "Q" or, for a mixed mesh, "Q+31T".
std::string type_text(const Json& cycle) {
  const std::int64_t triangles = cycle["triangles"], quads = cycle["quads"];
  if (quads == 0) return "T";
  return triangles == 0 ? "Q" : fmt::format("Q+{}T", triangles);
}

/// "62-118": the range of the corner angles in whole degrees. Results of older versions have none.
std::string angle_text(const Json& statistics) {
  const Json angle = statistics.value("angle", Json::object());
  return number_cell(angle.value("min", Json()), "{:.0f}-") +
         number_cell(angle.value("max", Json()), "{:.0f}");
}

/// Of quadrilaterals only.
std::string scaled_jacobian_text(const Json& cycle) {
  return cycle["quads"] == 0 ? "-"
                             : number_cell(cycle.value("scaled_jacobian_min", Json()), "{:.3f}");
}

std::vector<std::string> statistics_cells(const Json& cycle, const Json& statistics) {
  const Json& length = statistics["edge_length"];
  return {statistics["quality"]["against"].get<std::string>(),
          type_text(cycle),
          count(cycle["vertices"]),
          count(cycle["elements"]),
          count(cycle["edges"]),
          count(cycle["boundary_edges"]),
          number_cell(statistics["quality"]["mean"], "{:.3f}"),
          number_cell(statistics["quality"]["min"], "{:.3f}"),
          percent_cell(length["in_0.5_1.5"], 2),
          number_cell(length["min"], "{:.3f}"),
          number_cell(length["max"], "{:.3f}"),
          percent_cell(length["in_unit_band"], 2),
          angle_text(statistics),
          scaled_jacobian_text(cycle),
          error_text(cycle["error"])};
}

std::vector<std::string> paper_cells(const PaperRow& row) {
  const bool quads = has_quads(row);
  const int boundary_edges = 2 * row.edges - (quads ? 4 : 3) * row.elements;
  return {"paper",
          quads ? "Q" : "T",
          std::to_string(row.vertices),
          std::to_string(row.elements),
          std::to_string(row.edges),
          std::to_string(boundary_edges),
          fmt::format("{:.3f}", row.quality_mean),
          fmt::format("{:.3f}", row.quality_min),
          fmt::format("{:.2f}", row.percent_half),
          fmt::format("{:.2f}", row.length_min),
          fmt::format("{:.2f}", row.length_max),
          "-",
          "-",
          "-",
          "-"};
}

void add_row(TextTable& table, std::string name, std::vector<std::string> cells, bool reference) {
  cells.insert(cells.begin(), std::move(name));
  table.rows.push_back(std::move(cells));
  table.is_reference.push_back(reference);
}

void add_cycle(TextTable& table, const std::string& name, const Json& cycle) {
  add_row(table, name, statistics_cells(cycle, cycle), false);
  if (cycle["quality"]["against"] == "exact")
    add_row(table, "", statistics_cells(cycle, cycle["background"]), false);
}

TextTable empty_table(const std::string& first_column) {
  TextTable table;
  table.header = kColumns;
  table.header.insert(table.header.begin(), first_column);
  return table;
}

}  // namespace

TextTable summary_table(const Json& history) {
  TextTable table = empty_table("variant");
  for (const Json& variant : history["variants"]) {
    const std::string name = variant["name"];
    if (variant["cycles"].empty()) {
      std::vector<std::string> cells(kColumns.size(), "-");
      cells.front() = variant["stop_reason"];
      add_row(table, name, std::move(cells), false);
      continue;
    }
    add_cycle(table, name, variant["cycles"].back());
    const std::string row_name = variant["settings"].value("report.paper", std::string());
    if (const PaperRow* row = paper_row(row_name))
      add_row(table, fmt::format("  (Fig. {})", row->name), paper_cells(*row), true);
  }
  return table;
}

TextTable cycle_table(const Json& variant) {
  TextTable table = empty_table("cycle");
  for (const Json& cycle : variant["cycles"]) add_cycle(table, count(cycle["cycle"]), cycle);
  return table;
}

}  // namespace anisofront
