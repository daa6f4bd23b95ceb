#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// A rectangle of the plane.
struct PlaneWindow {
  Point low, high;
};

struct SvgOptions {
  double width = 1000;  ///< pixels; the height follows from what is drawn
  /// Draws only this part of the plane, with line widths for it; empty: the
  /// whole mesh.
  std::optional<PlaneWindow> window = {};
  /// The drawing is at most so many times as high as wide, with blanks on both sides of a tall
  /// mesh; 0: any.
  double highest = 0;
  /// A frame around a part that has a picture of its own.
  std::optional<PlaneWindow> framed = {};
  /// A bar below the mesh whose length is a round number, the greatest of 1, 2
  /// or 5 times a power of ten up to a quarter of the width.
  bool has_scale = false;
  /// One value per element (triangles, then quads), shown in 16 colours with a
  /// key below the mesh; NaN stays white. Empty: regions in soft tints.
  std::vector<double> values = {};
  std::string values_name = {};
};

/// Writes a drawing of the mesh: elements filled softly by region, thin grey
/// edges, curve edges dark (one path per tag), dots at required vertices. Line
/// widths suit the element count. Atomic. Throws InputError when an array does
/// not fit the mesh or its bounding box cannot be drawn.
void write_svg(const std::filesystem::path& path, const Mesh& mesh, const SvgOptions& options = {});

}  // namespace anisofront
