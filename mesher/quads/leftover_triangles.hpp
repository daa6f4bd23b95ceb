#pragma once

#include "mesher/quads/mixed_mesh.hpp"

namespace anisofront {

/// Walks the triangles that pairing has left to each other, two by two and nearest first, by
/// recutting the quadrilaterals between them (triangle + quad = pentagon = quad + triangle), and
/// merges them. Never crosses a segment. The faces are then conforming and anticlockwise in
/// topology but not necessarily convex: smoothing and clean-up repair that.
/// Returns the number of triangles left: none where every part of the mesh that is bounded by
/// segments has an even number of boundary edges, else one for each part.
Index merge_leftover_triangles(MixedMesh& mesh);

}  // namespace anisofront
