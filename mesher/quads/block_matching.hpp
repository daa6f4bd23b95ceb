#pragma once

#include <vector>

#include "mesher/front/work_mesh.hpp"
#include "mesher/quads/matching.hpp"

namespace anisofront {

/// maximum_weight_matching() of the triangles of a mesh, in blocks of neighbouring triangles: its
/// time grows faster than their number (1e5 triangles of a uniform mesh: 2 to 10 s), that of the
/// blocks is linear. Twice, with other blocks the second time, so that triangles at the edge of a
/// block can pair up again: measured on 1e5 triangles the weight is 1e-4 below the largest.
/// A mesh of one block has the exact matching. `pairs` name triangles and are ordered by `first`;
/// dead triangles have none. Per triangle its mate or kNoIndex. Deterministic.
std::vector<Index> match_in_blocks(const WorkMesh& mesh, const std::vector<WeightedPair>& pairs,
                                   std::size_t largest_block = 16000);

}  // namespace anisofront
