#pragma once

#include <array>
#include <vector>

#include "mesher/front/work_mesh.hpp"

namespace anisofront {

/// Two adjacent triangles, first < second, whose union is a strictly convex quadrilateral.
struct MergeCandidate {
  Index first = kNoIndex;
  Index second = kNoIndex;
  double beta = 0;  ///< beta~ of the union, > 0
};

/// Below this beta~ merging in order stops (the paper, section 3, step (i)): two triangles left do
/// less harm than such a quadrilateral.
inline constexpr double kLeastMergedBeta = 0.1;

/// The union of triangle t and its neighbour across side k (>= 0), from vertices[k] of t on:
/// anticlockwise, the common edge is the diagonal between corners 1 and 3.
std::array<Index, 4> merged_quad(const WorkMesh& mesh, Index t, int k);

/// All pairs that may be merged, by ascending `first`, then by its sides: both alive, no segment
/// between them, all four corners anticlockwise (exact predicate), beta~ > 0.
std::vector<MergeCandidate> merge_candidates(const WorkMesh& mesh);

}  // namespace anisofront
