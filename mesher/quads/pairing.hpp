#pragma once

#include <vector>

#include "mesher/quads/mixed_mesh.hpp"

namespace anisofront {

/// How triangles are merged to quadrilaterals.
enum class Pairing {
  beta_order,  ///< the best beta~ first, down to 0.1 (the paper, reference 28)
  matching,    ///< maximum-weight matching, weights from ln beta~; in blocks of 16000 triangles
  systematic,  ///< layer by layer from the boundary, so that hardly any triangle is left
               ///< (the paper, section 5, reference 29)
};

/// Merges pairs of triangles that share an edge which is no segment; pairs that are not strictly
/// convex (exact predicate) are never merged. Vertices and segments are kept with their numbers,
/// triangles without partner stay. `required` are numbers of vertices. Deterministic.
MixedMesh pair_triangles(const WorkMesh& mesh, const std::vector<Index>& required, Pairing pairing);

}  // namespace anisofront
