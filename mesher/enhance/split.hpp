#pragma once

#include "mesher/enhance/patch.hpp"

namespace anisofront {

/// Splits the interior edge ab of metric length `length` at its metric midpoint, when no new edge
/// is further from 1 (as a ratio) than the old one, and swaps around the new vertex. `near` is a
/// triangle that held the edge when it was listed. Returns whether it did.
bool split(Patch& patch, Index a, Index b, double length, Index near);

/// Splits the interior edge opposite vertex k at its metric midpoint whatever the lengths, if the
/// result is valid.
bool force_split(Patch& patch, Index triangle, int k);

/// Puts a vertex that must be kept into the mesh: on an existing vertex, into an edge or into a
/// triangle. `triangle` contains p. Returns the vertex; throws MeshingError when p lies on a
/// segment.
Index insert_vertex(Patch& patch, Index triangle, Point p);

}  // namespace anisofront
