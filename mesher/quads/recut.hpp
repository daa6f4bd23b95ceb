#pragma once

#include <array>

#include "mesher/quads/face_links.hpp"

namespace anisofront {

/// Another way to cut a triangle and a quadrilateral beside it: `outer` are the sides of their
/// union, a pentagon; the new triangle takes the first two of them, the new quadrilateral the rest.
struct Recut {
  Index triangle = kNoIndex, quad = kNoIndex;  ///< faces
  std::array<Index, 5> outer{};                ///< half-edges, anticlockwise
  double cost = 0;                             ///< of the two new faces
  bool possible() const { return triangle != kNoIndex; }
};

/// Defect of a face, the less the better: -ln beta~ or -2 ln alpha~; inverted faces cost 20 and
/// more, but are not refused.
double face_cost(const std::vector<WorkVertex>& vertices, const MixedFace& face);

/// The cheapest cut of triangle and quad after which the triangle has a side open to face `goal`,
/// a neighbour of the quad. Both new faces have distinct vertices, and no edge comes to be twice.
/// Not possible only where the goal can be reached nowhere but round the end of a segment in the
/// quad. Precondition: triangle and quad share an open side.
Recut best_recut(const FaceLinks& links, const std::vector<WorkVertex>& vertices, Index triangle,
                 Index quad, Index goal);

/// Afterwards face `quad` is the triangle and face `triangle` the quadrilateral.
void apply(FaceLinks& links, const Recut& recut);

/// Merges two triangles with an open side in common to the quadrilateral `first`; `second` is dead
/// (vertices[0] == kNoIndex).
void merge(FaceLinks& links, Index first, Index second);

}  // namespace anisofront
