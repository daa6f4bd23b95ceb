#pragma once

#include "solver/space/fe_mesh.hpp"

namespace anisofront {

/// The vertex of an element next to p (of several the one of smallest number). O(n).
/// Throws InputError, beginning with `what`, where p lies outside the box round the mesh.
Index nearest_vertex(const FeMesh& mesh, Point p, const char* what);

}  // namespace anisofront
