#pragma once

#include <array>
#include <vector>

#include "solver/space/fe_mesh.hpp"

namespace anisofront {

/// Side k of an element, from its corner k to corner k + 1.
struct ElementSide {
  Index element = kNoIndex;
  int side = 0;
};

/// Per edge of the mesh the elements on its two sides, the smaller number first; the second is
/// kNoIndex on the boundary.
using EdgeSides = std::vector<std::array<ElementSide, 2>>;
EdgeSides edge_sides(const FeMesh& mesh);

}  // namespace anisofront
