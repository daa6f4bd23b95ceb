#pragma once

#include <span>

#include "mesher/background/background_mesh.hpp"
#include "mesher/quads/mixed_topology.hpp"

namespace anisofront {

/// Where vertex v would lie at unit distance from its neighbours along edges and at sqrt(2) from
/// the opposite corners of quadrilaterals: the centroid of the places of Eqns 25a and 25b (with
/// ERRATA). `corners` are those of all faces around v; each face contributes the edge to its next
/// vertex, so that round an inner vertex every edge counts once.
Point ideal_place_by_lengths(const BackgroundMesh& background, const MixedMesh& mesh, Index v,
                             std::span<const Corner> corners);

/// Where the faces around it would be unit equilateral triangles and unit squares: the centroid of
/// the places of Eqns 26 and 27.
Point ideal_place_by_shapes(const BackgroundMesh& background, const MixedMesh& mesh, Index v,
                            std::span<const Corner> corners);

}  // namespace anisofront
