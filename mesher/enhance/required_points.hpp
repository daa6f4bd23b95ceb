#pragma once

#include <vector>

#include "mesher/enhance/patch.hpp"

namespace anisofront {

/// Puts the points into the mesh as fixed vertices and returns their numbers, in order. The search
/// is by alternating digital tree. Throws MeshingError for points outside the mesh.
std::vector<Index> insert_required_points(Patch& patch, const std::vector<Point>& points);

}  // namespace anisofront
