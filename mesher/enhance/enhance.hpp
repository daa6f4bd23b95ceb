#pragma once

#include "mesher/enhance/patch.hpp"
#include "mesher/geometry/monitor.hpp"

namespace anisofront {

struct EnhanceOptions {
  /// true: swapping, three cycles of length and three of quality smoothing (the paper); false: the
  /// faster chain with collapses, splits and targeted smoothing.
  bool paper = false;
  /// Meshes up to this many triangles get more repairs and finer smoothing: half of the time for
  /// the last percent of quality, which a user waits for gladly only where the time is short.
  std::size_t fine_up_to = 60000;
};

/// Improves the triangles (section 3, "Mesh quality enhancement"). Segments and fixed vertices
/// stay.
void enhance(Patch& patch, const EnhanceOptions& options, const Monitor& monitor = {});

}  // namespace anisofront
