#pragma once

#include <vector>

#include "mesher/quads/pairing_candidates.hpp"

namespace anisofront {

/// Merges triangles layer by layer from the segments inwards: per triangle its mate, or kNoIndex.
/// A front of edges separates what is merged from the triangles that remain. The triangle at a
/// front edge takes the neighbour with which it makes the best quadrilateral, the best of a layer
/// first; but one with a single neighbour left comes before all others, so that hardly any triangle
/// stays alone. (Keeping the number of edges even in every loop of the front as well was tried: the
/// same numbers of triangles are left.) Merges down to kLeastMergedBeta. Deterministic; O(n log n).
/// Reference: C. K. Lee, S. H. Lo, A new scheme for the generation of a graded quadrilateral mesh,
/// Comput. Struct. 52 (1994) (reference 29 of the paper): the idea, not their swapping and
/// insertion of vertices, for merge_leftover_triangles() removes what remains.
std::vector<Index> systematic_merging(const WorkMesh& mesh,
                                      const std::vector<MergeCandidate>& candidates);

}  // namespace anisofront
