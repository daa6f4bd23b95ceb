#pragma once

#include <filesystem>

#include "mesher/mesh/mesh.hpp"

namespace anisofront {

struct SvgOptions {
  double width = 1000;  ///< pixels; the height follows from the bounding box
};

/// Writes a drawing of the mesh: elements filled softly by region, thin grey edges, curve edges
/// dark (one path per tag), dots at required vertices. Line widths suit the element count. Atomic.
void write_svg(const std::filesystem::path& path, const Mesh& mesh, const SvgOptions& options = {});

}  // namespace anisofront
