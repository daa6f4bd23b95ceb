#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/base/json.hpp"

namespace anisofront {

struct Figure {
  std::string file;  ///< name in the folder of the figures
  std::string caption;
  std::string variant;  ///< empty: about all of them
};

/// Draws with gnuplot into `folder`: per variant the edge-length distributions of all cycles (the
/// paper's Figs. 16 and 17), and the error against the number of unknowns where errors are known.
/// Data (.dat) and script (.gp) stay beside each figure, to be restyled. Without gnuplot on the
/// PATH only these are written and `problem` says so.
struct FigureList {
  std::vector<Figure> figures;
  std::string problem;  ///< why some are not drawn; empty: all are
};
FigureList draw_figures(const Json& history, const std::filesystem::path& folder);

}  // namespace anisofront
