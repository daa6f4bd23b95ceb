#pragma once

#include "mesher/background/background_mesh.hpp"
#include "mesher/geometry/domain.hpp"
#include "mesher/quads/mixed_mesh.hpp"

namespace anisofront {

/// Steps (iii) and (iv) of the conversion. With pentagons: isolated triangles, one by one, are
/// joined with the neighbouring quadrilateral of least angle deviation (Eqn 28) with which they
/// make a pentagon that can be divided into five convex quadrilaterals, none of them with a corner
/// of the triangle above 165 degrees; never across a segment.
/// Then every face is divided (Fig. 11): triangles into 3, quadrilaterals into 4, pentagons into 5,
/// by the midpoints of their edges and a vertex at the centroid of these.
///
/// Midpoints halve the metric length of edges (Eqn 29); those of segments lie on their curve, at
/// the parameter of half the metric length. Segments are halved in place, segment s becoming
/// segments 2 s and 2 s + 1. `background` holds the metric of the DIVIDED mesh: the metrics of old
/// vertices are looked up again. With pentagons lengths are those of Appendix B to the letter, else
/// (for meshes that are improved afterwards) by half as many samples as the metric needs.
///
/// Old vertices keep their numbers; edge midpoints follow, then centres; none of them is required.
/// The quadrilaterals of face f come together, in the order of the faces; a pentagon takes the
/// place of its triangle. All faces of the result are quadrilaterals; the children of strictly
/// convex faces are strictly convex unless a curve bulges so far into a face that there is no
/// centre for it. O(n) without pentagons as with them.
/// Precondition: conforming faces with anticlockwise vertices.
MixedMesh divide_mixed(const Domain& domain, const BackgroundMesh& background,
                       const MixedMesh& mesh, bool with_pentagons);

}  // namespace anisofront
