#include <algorithm>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text_table.hpp"
#include "drivers/run/solution_json.hpp"

namespace anisofront {
namespace {

using Lines = std::vector<std::pair<std::string, std::string>>;

std::string mesh_text(const FeMesh& mesh) {
  std::string text = fmt::format("{} vertices", mesh.mesh.points.size());
  if (!mesh.mesh.triangles.empty())
    text += fmt::format(", {} triangles", mesh.mesh.triangles.size());
  if (!mesh.mesh.quads.empty()) text += fmt::format(", {} quadrilaterals", mesh.mesh.quads.size());
  const auto bent = std::count(mesh.edge_is_bent.begin(), mesh.edge_is_bent.end(), char{1});
  return bent > 0 ? text + fmt::format(", {} curved edges", bent) : text;
}

std::string unknowns_text(const Solved& solved) {
  std::string text = std::to_string(solved.linear.unknowns);
  for (const auto& [key, value] : solved.settings.items())
    text +=
        fmt::format(", {} {}", key, value.is_string() ? value.get<std::string>() : value.dump());
  return text;
}

std::string linear_text(const LinearReport& report) {
  std::string text = fmt::format("{}: residual {:.1e}", report.method, report.residual);
  if (report.condition > 0) text += fmt::format(", condition {:.1e}", report.condition);
  if (report.refinements > 0)
    text += fmt::format(", {} refinement{}", report.refinements, report.refinements > 1 ? "s" : "");
  if (report.iterations > 0) text += fmt::format(", {} iterations", report.iterations);
  return text;
}

std::string seconds_text(const SolutionRecord& record) {
  const LinearReport& linear = record.solved.linear;
  return fmt::format("mesh {:.2f}, assembly {:.2f}, factor {:.2f}, solve {:.2f}, fields {:.2f}",
                     record.seconds.mesh, record.solved.assembly_seconds, linear.factor_seconds,
                     linear.solve_seconds, record.seconds.fields);
}

TextTable value_table(const SolutionRecord& record) {
  TextTable table;
  table.header = {"name", "at"};
  const auto& names = record.solved.state.quantities.at_point;
  table.header.insert(table.header.end(), names.begin(), names.end());
  for (const SampledValue& value : record.samples.values) {
    table.rows.push_back({value.name, fmt::format("({:.6g}, {:.6g})", value.at.x, value.at.y)});
    for (const double x : value.state) table.rows.back().push_back(fmt::format("{:.6g}", x));
  }
  return table;
}

}  // namespace

std::string solution_summary(const SolutionRecord& record) {
  Lines lines{{"mesh", mesh_text(record.mesh)},
              {"unknowns", unknowns_text(record.solved)},
              {"system", linear_text(record.solved.linear)},
              {"seconds", seconds_text(record)}};
  const Lines& own = record.solved.summary;
  lines.insert(lines.end(), own.begin(), own.end());
  std::string text = record.variant.study.title;
  if (record.variant.name != "main") text += " (" + record.variant.name + ")";
  for (const auto& [name, value] : lines) text += fmt::format("\n  {:<10}{}", name, value);
  if (!record.samples.values.empty()) text += "\n\n" + as_text(value_table(record));
  return text;
}

}  // namespace anisofront
