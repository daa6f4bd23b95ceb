#pragma once

#include "mesher/geometry/point.hpp"

namespace anisofront {

/// A directed edge of the front; the part still to be meshed lies on its left. Exactly one cache
/// line: the coordinates are copied here because every query of the front tests them.
struct alignas(64) FrontEdge {
  Point a, b;
  Index va = kNoIndex, vb = kNoIndex;
  Index next_out = kNoIndex;   ///< next front edge that leaves va
  Index version = 0;           ///< counts the edges that have used this slot
  Index cell_next = kNoIndex;  ///< list of the cell of the search structure
  Index cell_previous = kNoIndex;
  Index cell = kNoIndex;
  Index behind = kNoIndex;  ///< 3 t + k: edge k of triangle t; ~s: segment s
};
static_assert(sizeof(FrontEdge) == 64);

}  // namespace anisofront
