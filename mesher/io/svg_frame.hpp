#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "mesher/io/atomic_file.hpp"
#include "mesher/io/svg.hpp"

namespace anisofront {

/// From the plane to the drawing: y down, margins all round, room for the key
/// at the bottom.
struct SvgFrame {
  PlaneWindow shown;
  double margin = 0;
  double scale = 1;  ///< pixels per unit of the plane
  double width = 0;
  double picture_height = 0;  ///< with margins, without the key
  double height = 0;

  Point operator()(Point p) const {
    return {margin + scale * (p.x - shown.low.x), margin + scale * (shown.high.y - p.y)};
  }
};

/// Whether the bounding box of some vertices meets what is drawn.
template <class Vertices>
bool is_shown(const Mesh& mesh, const SvgFrame& frame, const Vertices& vertices) {
  bool left = true, right = true, below = true, above = true;
  for (const Index v : vertices) {
    const Point p = mesh.points[static_cast<std::size_t>(v)];
    left = left && p.x < frame.shown.low.x;
    right = right && p.x > frame.shown.high.x;
    below = below && p.y < frame.shown.low.y;
    above = above && p.y > frame.shown.high.y;
  }
  return !(left || right || below || above);
}

/// Pixels, to a thousandth: enough for zooming in.
inline void write_pixels(AtomicFile& out, double value) {
  out.real(std::round(1000 * value) / 1000);
}

inline void write_attribute(AtomicFile& out, std::string_view name, double value) {
  out.text(" ");
  out.text(name);
  out.text("=\"");
  write_pixels(out, value);
  out.text("\"");
}

}  // namespace anisofront
