#pragma once

#include <vector>

#include "mesher/enhance/patch.hpp"
#include "mesher/geometry/domain.hpp"

namespace anisofront {

/// Puts the points into the mesh as fixed vertices and returns their numbers, in order. The search
/// is by alternating digital tree. Throws MeshingError for points outside the mesh.
std::vector<Index> insert_required_points(Patch& patch, const std::vector<Point>& points);

/// Domain points inside regions, those without a vertex yet, become vertices; the numbers are
/// entered in `point_vertices` (one per domain point).
void insert_inner_points(const Domain& domain, Patch& patch, std::vector<Index>& point_vertices);

}  // namespace anisofront
