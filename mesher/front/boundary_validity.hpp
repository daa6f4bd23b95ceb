#pragma once

#include <optional>
#include <vector>

#include "mesher/front/work_mesh.hpp"

namespace anisofront {

/// Two segments that cross, touch or overlap, and a point where they do.
struct SegmentConflict {
  Index first = kNoIndex, second = kNoIndex;
  Point place;
};

/// All pairs of segments of the mesh that meet anywhere else than in a common end vertex.
/// O(n log n) on average.
std::vector<SegmentConflict> find_conflicts(const WorkMesh& mesh);

/// Two segments without a common vertex that are nearer to each other than `distance` in the metric
/// of their vertices; the first pair found.
std::optional<SegmentConflict> find_narrow_gap(const WorkMesh& mesh, double distance);

/// Whether p lies inside the closed polygon (or polygons) formed by the given segments, in any
/// order and direction: exact except for points on the polygon itself.
bool is_inside(const WorkMesh& mesh, const std::vector<Index>& segments, Point p);

}  // namespace anisofront
