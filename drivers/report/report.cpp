#include "drivers/report/report.hpp"

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "drivers/report/figures.hpp"
#include "drivers/report/html.hpp"
#include "drivers/report/summary.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/io/gmsh.hpp"
#include "mesher/io/svg.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

Json read_history(const fs::path& directory) {
  const fs::path path = directory / "history.json";
  if (!fs::exists(path))
    throw UsageError(path.string() +
                     ": no such file; give a folder that `anisofront run` has left");
  const Json history = Json::parse(read_text_file(path), nullptr, false);
  if (history.is_discarded() || !history.is_object() || history.value("schema", 0) != 1)
    throw InputError(path.string() + ": not a history of schema 1");
  return history;
}

/// Draws the mesh of the last cycle; the name of the drawing, or empty without such a mesh.
std::string draw_mesh(const fs::path& directory, const Json& variant) {
  const std::string name = variant["name"];
  if (variant["cycles"].empty()) return {};
  const int cycle = variant["cycles"].back()["cycle"];
  const fs::path mesh = directory / name / fmt::format("cycle-{}.msh", cycle);
  if (!fs::exists(mesh)) return {};
  const std::string drawing = name + "-mesh.svg";
  write_svg(directory / "figures" / drawing, read_gmsh(mesh).mesh);
  return drawing;
}

std::string figures_of(const FigureList& list, const std::string& variant, const fs::path& folder) {
  std::string html;
  for (const Figure& figure : list.figures)
    if (figure.variant == variant) html += html_figure(folder / figure.file, figure.caption);
  return html;
}

std::string settings_line(const Json& variant) {
  std::string line;
  for (const auto& [key, value] : variant["settings"].items())
    line += fmt::format("<code>{} = {}</code> ", html_text(key),
                        html_text(value.is_string() ? value.get<std::string>() : value.dump()));
  return line;
}

std::string warnings_list(const Json& variant) {
  std::string html;
  for (const Json& cycle : variant["cycles"])
    for (const Json& warning : cycle["warnings"])
      html += fmt::format("<li>cycle {}: {}</li>", cycle["cycle"].get<int>(),
                          html_text(warning.get<std::string>()));
  return html.empty() ? html : "<ul class=\"warnings\">" + html + "</ul>\n";
}

std::string variant_section(const Json& variant, const FigureList& list,
                            const fs::path& directory) {
  const std::string name = variant["name"];
  const fs::path folder = directory / "figures";
  std::string html =
      fmt::format("<section>\n<h2>{}</h2>\n<p>{}</p>\n<p>{}</p>\n", html_text(name),
                  settings_line(variant), html_text(variant["stop_reason"].get<std::string>()));
  html += html_table(cycle_table(variant));
  html += warnings_list(variant);
  html += "<div class=\"pair\">\n";
  const std::string drawing = draw_mesh(directory, variant);
  if (!drawing.empty()) html += html_figure(folder / drawing, "Mesh of the last cycle");
  return html + figures_of(list, name, folder) + "</div>\n</section>\n";
}

const char* const kLegend =
    "<p>Type: T triangles, Q quadrilaterals. NN vertices, NE elements, ND edges, NB boundary "
    "edges. "
    "Mean (geometric) and min: element quality of the paper, &alpha;&#771; of triangles and "
    "&beta;&#771; of quadrilaterals, 1 for an element that fits the metric. Lengths are those of "
    "the edges in the metric, ideally 1; unit band: share of edges in [1/&radic;2, &radic;2]. "
    "Angles: of the corners, in the metric, degrees; min sJ: least scaled Jacobian of the "
    "quadrilaterals, in the plane. "
    "Exact: against the formula of a prescribed metric; background: against its interpolant on "
    "the mesh before. Error: relative, in the energy norm (~: estimated).</p>\n";

}  // namespace

std::vector<std::string> make_report(const fs::path& directory) {
  const Json history = read_history(directory);
  const FigureList list = draw_figures(history, directory);
  std::string body = html_table(summary_table(history)) + kLegend;
  body += figures_of(list, "", directory / "figures");
  for (const Json& variant : history["variants"]) body += variant_section(variant, list, directory);
  write_text_file(directory / "report.html", html_page(history["title"], body));
  return list.problems;
}

}  // namespace anisofront
