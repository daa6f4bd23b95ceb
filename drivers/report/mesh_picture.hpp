#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/base/json.hpp"
#include "drivers/report/figure_folder.hpp"

namespace anisofront {

/// A drawing of a mesh, STEM.svg in the folder of the figures.
struct MeshPicture {
  std::string stem;
  std::string caption;
  std::string variant;  ///< empty: about all of them
};

/// Draws the last mesh of each variant of which a file is there: NAME-mesh; NAME-mesh-zoom, a part
/// with thin elements that the first one frames (see detail_window()); and NAME-solution, the
/// elements coloured by the first scalar field at the vertices. mesh-initial shows the mesh all
/// variants start from; where they differ each has its NAME-mesh-initial. All have a scale bar.
std::vector<MeshPicture> draw_meshes(const Json& history, const std::filesystem::path& directory,
                                     FigureFolder& folder);

/// STEM.png of the pictures with rsvg-convert, 1200 pixels wide. Returns what went wrong, at most
/// one sentence.
std::vector<std::string> convert_pictures(const std::vector<MeshPicture>& pictures,
                                          FigureFolder& folder);

}  // namespace anisofront
