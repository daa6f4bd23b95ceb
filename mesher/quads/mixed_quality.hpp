#pragma once

#include "mesher/quads/mixed_mesh.hpp"

namespace anisofront {

/// All corners anticlockwise by the exact predicate, those of quadrilaterals not flat either.
bool is_strictly_convex(const MixedMesh& mesh, const MixedFace& face);

/// alpha~ of a triangle (Eqn 15), beta~ of a quadrilateral (Eqn 16).
double shape_quality(const MixedMesh& mesh, const MixedFace& face);

/// mu~ (Eqn 17): shape_quality() and how near to 1 the edges are, measured by the metrics at their
/// ends (A12).
double combined_quality(const MixedMesh& mesh, const MixedFace& face);

using FaceQuality = double (*)(const MixedMesh& mesh, const MixedFace& face);

/// How good a set of faces is.
struct Shape {
  int broken = 0;      ///< faces that are not strictly convex or of no positive quality
  double product = 1;  ///< of the qualities of the others
  double worst = 1;    ///< the least of them
  void add(const MixedMesh& mesh, const MixedFace& face, FaceQuality quality = shape_quality);
};

/// Fewer broken faces or, where none is broken, a larger product: the rule by which the paper
/// accepts a new place, extended to faces that merging has left with a negative quality.
inline bool is_better(const Shape& after, const Shape& before) {
  if (after.broken != before.broken) return after.broken < before.broken;
  return after.broken == 0 && after.product > before.product;
}

}  // namespace anisofront
