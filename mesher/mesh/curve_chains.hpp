#pragma once

#include <vector>

#include "mesher/mesh/boundary_domain.hpp"

namespace anisofront::detail {

/// An edge of the boundary, of an interface or of an embedded curve, with the edge-connected parts
/// on both sides. Boundary edges run with the mesh to their left.
struct SidedEdge {
  std::array<Index, 2> vertices{kNoIndex, kNoIndex};
  Index tag = 0;          ///< of the mesh edge that lies here, 0 without one
  Index left = kNoIndex;  ///< part, see CurveEdges::part_tags
  Index right = kNoIndex;
};

struct CurveEdges {
  std::vector<SidedEdge> edges;     ///< first those of Mesh::edges in their order, then the others
  std::vector<Index> of_mesh_edge;  ///< Mesh::edges -> edges (duplicates share one)
  std::vector<Index> part_tags;     ///< region tag per part; parts in the order of their elements
};

/// Finds the edges above. A part is a set of elements of one region tag connected through edges.
/// O(n) in the number of elements. Throws InputError naming the vertices of edges that more than
/// two elements share, that two elements run through in the same direction, that belong to no
/// element, and of vertex numbers out of range.
CurveEdges find_curve_edges(const Mesh& mesh);

/// A maximal run of edges with equal tag and equal parts on its sides, without a break inside.
struct Chain {
  std::vector<Index> vertices;  ///< in walking order; first == last when closed
  std::vector<Index> edges;     ///< indices into CurveEdges::edges
  Index tag = 0;
  Index left = kNoIndex;
  Index right = kNoIndex;
  bool smooth_seam = false;  ///< closed, and no corner where it closes
};

/// Chains in the order of their first edges. Breaks: vertices with other than two edges, changes
/// of tag, turning above the corner angle, Mesh::corners, and `required` (flag per vertex).
/// A loop without breaks starts at the first vertex of its first edge.
std::vector<Chain> chain_edges(const Mesh& mesh, const std::vector<SidedEdge>& edges,
                               const std::vector<char>& required, double corner_angle);

}  // namespace anisofront::detail
