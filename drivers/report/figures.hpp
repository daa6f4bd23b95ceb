#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/base/json.hpp"

namespace anisofront {

struct Figure {
  std::string file;  ///< the .svg, a name in figures/
  std::string caption;
  std::string variant;             ///< empty: about all of them
  std::vector<std::string> files;  ///< all that were made of it: drawings, data, script
};

struct FigureList {
  std::vector<Figure> figures;
  std::vector<std::string> problems;  ///< why some are not drawn, one sentence each
};

/// Makes figures/ of a results folder anew: plots with gnuplot as .svg, .pdf and .png, their data
/// (.dat) and script (.gp) beside them (see figure_plots.hpp), and pictures of the meshes (see
/// mesh_picture.hpp). An existing style.gp is kept. With more than twelve variants the plots of a
/// single one are left as data and scripts, which make-all.gp draws, and meshes as .svg only.
/// Without gnuplot or rsvg-convert on the PATH only what needs them is missing and `problems` says
/// so. Throws InputError when `history` is not as history_json() says or a file cannot be written.
FigureList draw_figures(const Json& history, const std::filesystem::path& directory);

}  // namespace anisofront
