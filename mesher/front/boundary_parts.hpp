#pragma once

#include <array>
#include <vector>

#include "mesher/front/work_mesh.hpp"

namespace anisofront {

/// The connected parts into which the segments of a mesh cut the regions: an embedded curve that
/// closes a loop, alone or with others, cuts a region into several.
struct BoundaryParts {
  Index count = 0;
  /// Per segment: the part on its left and on its right, kNoIndex outside the domain. Both are the
  /// same for embedded curves that cut nothing off.
  std::vector<std::array<Index, 2>> of_segment;
};

/// Follows the segments round every part, exactly (angles by predicate); parts are numbered by
/// their first segment. Preconditions: no conflicts between segments (see find_conflicts).
/// O(n log n) where regions are not cut; there, every hole is looked for in every part.
BoundaryParts find_parts(const WorkMesh& mesh);

/// Parts with an odd number of boundary edges, ascending; an edge with the same part on both sides
/// counts twice.
std::vector<Index> odd_parts(const BoundaryParts& parts);

}  // namespace anisofront
