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

/// Draws with gnuplot into figures/ of a results folder: per variant the edge-length distributions
/// of all cycles (the paper's Figs. 16 and 17), and the error against the number of unknowns where
/// errors are known. Data (.dat) and script (.gp) stay beside each figure, to be restyled. Without
/// gnuplot on the PATH only these are written and `problems` says so.
FigureList draw_figures(const Json& history, const std::filesystem::path& directory);

}  // namespace anisofront
