#include "drivers/report/figures.hpp"

#include <spdlog/fmt/fmt.h>

#include "drivers/base/process.hpp"
#include "drivers/base/text.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

const char* const kStyle =
    "set encoding utf8\n"
    "set terminal svg size 720,440 font 'sans-serif,13' background '#ffffff'\n"
    "set border 3 lc '#555555'\nset tics nomirror\nset grid lc '#dddddd'\n"
    "set style line 1 lc '#bbbbbb' lw 1.5 pt 7 ps 0.5\n"
    "set style line 2 lc '#88ccee' lw 1.5 pt 7 ps 0.5\n"
    "set style line 3 lc '#44aa99' lw 1.5 pt 5 ps 0.5\n"
    "set style line 4 lc '#ddaa33' lw 1.5 pt 9 ps 0.5\n"
    "set style line 5 lc '#aa4499' lw 1.5 pt 11 ps 0.5\n"
    "set style line 6 lc '#332288' lw 2 pt 13 ps 0.5\n";

/// Inside single quotes of gnuplot.
std::string quoted(const std::string& text) {
  std::string safe;
  for (const char c : text) safe += c == '\'' ? std::string("''") : std::string(1, c);
  return "'" + safe + "'";
}

/// Percent of the edges per histogram bin: one line per bin (its middle), one column per cycle.
std::string length_data(const Json& cycles) {
  std::string data = "# length";
  for (const Json& cycle : cycles) data += fmt::format(" cycle{}", cycle["cycle"].get<int>());
  data += '\n';
  const std::size_t bins = cycles[0]["edge_length"]["histogram"]["counts"].size();
  for (std::size_t bin = 0; bin < bins; ++bin) {
    data += fmt::format("{:.2f}", 0.1 * static_cast<double>(bin) + 0.05);
    for (const Json& cycle : cycles) {
      const double edges = cycle["edges"];
      const double count = cycle["edge_length"]["histogram"]["counts"][bin];
      data += fmt::format(" {:.4f}", 100 * count / edges);
    }
    data += '\n';
  }
  return data;
}

std::string length_script(const std::string& stem, const Json& cycles, const std::string& title) {
  std::string script = kStyle;
  script += fmt::format("set output '{}.svg'\nset title {} noenhanced\n", stem, quoted(title));
  script +=
      "set xlabel 'edge length in the metric'\nset ylabel 'edges, percent'\nset xrange [0:3.1]\n"
      "set arrow from 0.7071,graph 0 to 0.7071,graph 1 nohead dt 2 lc '#999999'\n"
      "set arrow from 1.4142,graph 0 to 1.4142,graph 1 nohead dt 2 lc '#999999'\nplot ";
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const int cycle = cycles[i]["cycle"];
    const std::string name = cycle == 0 ? "initial mesh" : fmt::format("cycle {}", cycle);
    script += fmt::format("{}'{}.dat' using 1:{} with linespoints ls {} title '{}'",
                          i == 0 ? "" : ", \\\n  ", stem, i + 2, i % 6 + 1, name);
  }
  return script + '\n';
}

void write_pair(const fs::path& folder, const std::string& stem, const std::string& data,
                const std::string& script) {
  write_text_file(folder / (stem + ".dat"), data);
  write_text_file(folder / (stem + ".gp"), script);
}

bool has_error(const Json& variant) {
  for (const Json& cycle : variant["cycles"])
    if (!cycle["error"]["relative_energy"].is_null() || !cycle["error"]["estimate"].is_null())
      return true;
  return false;
}

double error_of(const Json& cycle) {
  const Json& exact = cycle["error"]["relative_energy"];
  const Json& value = exact.is_number() ? exact : cycle["error"]["estimate"];
  return value.is_number() ? value.get<double>() : 0;
}

/// One block of "unknowns error" per variant.
std::string convergence_data(const Json& variants) {
  std::string data;
  for (const Json& variant : variants) {
    data += "# " + variant["name"].get<std::string>() + "\n";
    for (const Json& cycle : variant["cycles"])
      if (error_of(cycle) > 0)
        data += fmt::format("{} {:.6e}\n", cycle["dofs"].get<int>(), error_of(cycle));
    data += "\n\n";
  }
  return data;
}

std::string convergence_script(const Json& variants, const std::string& title) {
  std::string script = kStyle;
  script += fmt::format("set output 'convergence.svg'\nset title {} noenhanced\n", quoted(title));
  script +=
      "set logscale xy\nset format y '10^{%L}'\nset xlabel 'unknowns'\n"
      "set ylabel 'relative energy error'\nplot ";
  for (std::size_t i = 0; i < variants.size(); ++i)
    script += fmt::format(
        "{}'convergence.dat' index {} using 1:2 with linespoints ls {} title {} noenhanced",
        i == 0 ? "" : ", \\\n  ", i, (i + 1) % 6 + 1, quoted(variants[i]["name"]));
  return script + '\n';
}

/// Empty when all went well, else what did not.
std::string run_gnuplot(const fs::path& folder, const std::string& stem) {
  const int status = run_program_in(folder, {"gnuplot", stem + ".gp"});
  if (status == 0) return {};
  if (status == kProgramNotFound)
    return "gnuplot is not installed: figures are left as data and scripts in " + folder.string();
  return fmt::format("gnuplot failed on {} (status {}); run it by hand to see why",
                     (folder / (stem + ".gp")).string(), status);
}

}  // namespace

FigureList draw_figures(const Json& history, const fs::path& directory) {
  const fs::path folder = directory / "figures";
  make_folder(folder);
  FigureList list;
  const auto draw = [&](const std::string& stem, const std::string& caption,
                        const std::string& variant) {
    const std::string problem = run_gnuplot(folder, stem);
    if (problem.empty())
      list.figures.push_back(
          {stem + ".svg", caption, variant, {stem + ".svg", stem + ".dat", stem + ".gp"}});
    else if (list.problems.empty())
      list.problems.push_back(problem);
  };
  const std::string title = history["title"];
  Json with_error = Json::array();
  for (const Json& variant : history["variants"]) {
    if (variant["cycles"].empty()) continue;
    const std::string name = variant["name"];
    const std::string stem = name + "-edge-lengths";
    write_pair(folder, stem, length_data(variant["cycles"]),
               length_script(stem, variant["cycles"], title + ": " + name));
    draw(stem, "Edge-length distribution per cycle", name);
    if (has_error(variant)) with_error.push_back(variant);
  }
  if (with_error.empty()) return list;
  write_pair(folder, "convergence", convergence_data(with_error),
             convergence_script(with_error, title));
  draw("convergence", "Error against the number of unknowns", "");
  return list;
}

}  // namespace anisofront
