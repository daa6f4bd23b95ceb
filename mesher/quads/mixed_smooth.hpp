#pragma once

#include "mesher/background/background_mesh.hpp"
#include "mesher/quads/mixed_mesh.hpp"

namespace anisofront {

/// Steps (ii) and (v) of the conversion on triangles and quadrilaterals: `cycles` cycles of length
/// smoothing (Eqns 25a, 25b) and as many of quality smoothing (Eqns 26, 27). A vertex moves only if
/// the product of alpha~ and beta~ around it grows and all faces stay convex (where some are not,
/// if there are fewer of them then). Vertices on segments and required ones are fixed.
/// Precondition: the mesh is conforming and its vertices carry the metric of the background.
void smooth_mixed(const BackgroundMesh& background, MixedMesh& mesh, int cycles = 3);

/// What smooth_mixed() leaves: `sweeps` over all free vertices, each of which is brought by pattern
/// search, after the place of Eqns 26 and 27, to where the product of mu~ (Eqn 17) around it is
/// largest. Faces stay convex, or fewer are not. Not in the paper, whose centroids are taken or
/// left as a whole, and are too often left: see paper_quads() for what it changes.
/// Precondition: as above.
void search_mixed(const BackgroundMesh& background, MixedMesh& mesh, int sweeps = 1);

}  // namespace anisofront
