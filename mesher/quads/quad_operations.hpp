#pragma once

#include "mesher/quads/quad_work.hpp"

namespace anisofront {

/// Local operations on the topology of a quadrilateral mesh. Each begins a transaction and changes
/// the mesh; when it returns false, nothing has been changed or the transaction has been undone.
/// Interior vertices left with two quadrilaterals (doublets) are removed along the way. The caller
/// smooths, judges and commits or undoes.

/// Merges the vertex that h leaves with the opposite one of its quadrilateral, which disappears.
/// A boundary or required vertex survives in place, else the middle.
bool collapse_diagonal(QuadWork& work, Index h);

/// Turns the edge of h inside the hexagon of its two quadrilaterals, by one or two steps.
bool rotate_edge(QuadWork& work, Index h, int steps);

/// Splits an interior vertex: the quadrilaterals around it but `count`, from the one of the
/// half-edge `first` anticlockwise, go to a new vertex, and a new quadrilateral fills the gap.
bool split_vertex(QuadWork& work, Index first, int count);

/// Splits a boundary vertex: quadrilaterals number begin .. end - 1 of its fan go to a new interior
/// vertex, at least two. With begin == 0 or end == valence the new one has a side on the boundary.
bool split_boundary_vertex(QuadWork& work, Index v, int begin, int end);

/// Joins an interior vertex with the opposite corners of its quadrilaterals instead of with its
/// neighbours.
bool rotate_vertex(QuadWork& work, Index v);

/// Puts a smaller quadrilateral inside one and joins their corners: five for one. The cure for a
/// flat boundary vertex with one quadrilateral only, which no other operation can help.
bool inset_quad(QuadWork& work, Index quad);

/// Removes the doublets of a fresh mesh.
void remove_doublets(QuadWork& work);

}  // namespace anisofront
