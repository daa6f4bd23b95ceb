#pragma once

#include "mesher/background/background_mesh.hpp"
#include "mesher/quads/mixed_mesh.hpp"

namespace anisofront {

/// Step (ii), Fig. 9 (the figure is missing): two triangles IT1 and IT2 are removed and the
/// vertices P1 and P2 become one, Q, at their midpoint. Two readings of which these are, both done:
/// - IT1 and IT2 share the edge P1-P2, which collapses;
/// - IT1 and IT2 lie at the edges B-P1 and B-P2 of one quadrilateral B P2 X P1, which collapses
///   along its diagonal P1-P2; the triangles, which then share the edge B-Q, make a quadrilateral.
/// Of P1 and P2 a fixed one (on a segment or required) stays, and where both are nothing is done.
/// All faces around stay strictly convex and none of them gets a quality below 0.1 (where merging
/// stops too) that was better before; best first. The result wants smoothing.
/// Removed vertices stay in `vertices` without a face. Returns the number of triangles removed.
Index eliminate_triangles(const BackgroundMesh& background, MixedMesh& mesh);

}  // namespace anisofront
