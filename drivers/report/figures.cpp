#include "drivers/report/figures.hpp"

#include <algorithm>
#include <iterator>

#include "drivers/base/text.hpp"
#include "drivers/report/figure_folder.hpp"
#include "drivers/report/figure_gnuplot.hpp"
#include "drivers/report/figure_plots.hpp"
#include "drivers/report/figure_style.hpp"
#include "drivers/report/mesh_picture.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kManyVariants = 12;

void append(std::vector<Plot>& all, std::vector<Plot> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

std::vector<Plot> all_plots(const Json& history, const fs::path& directory) {
  std::vector<Plot> plots;
  for (auto* overview : {error_plots, comparison_plots, band_plots, timing_plots})
    append(plots, overview(history));
  for (const Json& variant : history.at("variants")) {
    append(plots, distribution_plots(variant));
    append(plots, profile_plots(variant, directory / variant.at("name").get<std::string>()));
  }
  return plots;
}

/// Data and scripts of all, which get their final stems.
void write_plots(std::vector<Plot>& plots, FigureFolder& folder) {
  std::string all = "# Draws all figures of this folder again.\n";
  for (Plot& plot : plots) {
    plot.stem = folder.free_stem(plot.stem);
    folder.write(plot.stem + ".dat", plot.data);
    folder.write(plot.stem + ".gp", plot_script(plot));
    all += "load '" + plot.stem + ".gp'\n";
  }
  if (!plots.empty()) folder.write("make-all.gp", all);
  folder.write("README.txt", figure_readme());
}

/// Whether style.gp is the original. A changed one is the user's and stays.
bool write_style(FigureFolder& folder) {
  folder.write("formats.gp", figure_formats());
  const fs::path path = folder.path() / "style.gp";
  if (fs::exists(path)) return read_text_file(path) == figure_style();
  write_text_file(path, figure_style());
  return true;
}

/// Draws plots; `has_all_formats`: as the original style asks for.
std::vector<std::string> draw(const std::vector<std::string>& stems, bool has_all_formats,
                              FigureFolder& folder) {
  std::vector<std::string> problems = run_gnuplot(folder.path(), stems);
  bool has_gaps = false;
  for (const std::string& stem : stems)
    for (const char* suffix : {".svg", ".pdf", ".png"})
      has_gaps = !folder.add(stem + suffix) || has_gaps;
  if (has_gaps && has_all_formats && problems.empty())
    problems.push_back("this gnuplot draws no .pdf or .png (it lacks the cairo terminals)");
  return problems;
}

/// Stems of the plots that are worth their time.
std::vector<std::string> drawn_stems(const std::vector<Plot>& plots, bool has_many) {
  std::vector<std::string> stems;
  for (const Plot& plot : plots)
    if (!has_many || plot.variant.empty()) stems.push_back(plot.stem);
  return stems;
}

void list_plots(FigureList& list, const std::vector<Plot>& plots, const FigureFolder& folder) {
  for (const Plot& plot : plots) {
    const std::string file = plot.stem + ".svg";
    if (fs::exists(folder.path() / file))
      list.figures.push_back({file, plot.caption, plot.variant, folder.files_of(plot.stem)});
  }
}

void add_pictures(FigureList& list, const std::vector<MeshPicture>& pictures, bool has_many,
                  FigureFolder& folder) {
  if (!has_many)
    for (const std::string& problem : convert_pictures(pictures, folder))
      list.problems.push_back(problem);
  for (const MeshPicture& picture : pictures)
    list.figures.push_back(
        {picture.stem + ".svg", picture.caption, picture.variant, folder.files_of(picture.stem)});
}

FigureList make_figures(const Json& history, const fs::path& directory) {
  FigureFolder folder(directory / "figures");
  const bool has_many = history.at("variants").size() > kManyVariants;
  std::vector<Plot> plots = all_plots(history, directory);
  write_plots(plots, folder);
  const bool is_original = write_style(folder);
  FigureList list;
  list.problems = draw(drawn_stems(plots, has_many), is_original, folder);
  list_plots(list, plots, folder);
  add_pictures(list, draw_meshes(history, directory, folder), has_many, folder);
  folder.write_list();
  return list;
}

}  // namespace

FigureList draw_figures(const Json& history, const fs::path& directory) {
  try {
    return make_figures(history, directory);
  } catch (const Json::exception& error) {
    throw InputError((directory / "history.json").string() +
                     ": not a history of schema 1: " + error.what());
  }
}

}  // namespace anisofront
