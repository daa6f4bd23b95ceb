#pragma once

#include <array>
#include <vector>

#include "mesher/front/work_mesh.hpp"

namespace anisofront {

/// Three or four anticlockwise vertices; vertices[3] == kNoIndex marks a triangle.
struct MixedFace {
  std::array<Index, 4> vertices{kNoIndex, kNoIndex, kNoIndex, kNoIndex};
  bool is_quad() const { return vertices[3] != kNoIndex; }
  int size() const { return is_quad() ? 4 : 3; }
};

/// A mesh of triangles and quadrilaterals in the making: what the stages of the conversion hand to
/// each other. Faces on the two sides of a segment share its vertices but are never merged across
/// it; each face belongs to the region that the segments around it say.
struct MixedMesh {
  std::vector<WorkVertex> vertices;
  std::vector<Segment> segments;
  std::vector<MixedFace> faces;
  std::vector<char> required;  ///< per vertex: a point of the domain inside a region, never moved
};

}  // namespace anisofront
