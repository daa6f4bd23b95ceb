#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// Neighbours of triangles: neighbours[t][k] is the triangle across the edge opposite vertex k,
/// or kNoIndex.
using TriangleNeighbours = std::vector<std::array<Index, 3>>;

/// O(n). Throws InputError naming the vertices of an edge that more than two triangles share or
/// that two triangles run through in the same direction, and for vertex numbers outside
/// 0 .. vertex_count - 1.
TriangleNeighbours triangle_neighbours(std::span<const Triangle> triangles, Index vertex_count);

/// A half-edge is one side of one element, run through with the element on its left. Half-edge
/// 3 t + k lies opposite vertex k of triangle t; 3 nt + 4 q + k starts at vertex k of quad q.
struct HalfEdge {
  Index from = kNoIndex;
  Index to = kNoIndex;
};

/// The elements of a mesh as a sequence of half-edges; views, nothing is owned.
struct HalfEdges {
  std::span<const Triangle> triangles;
  std::span<const Quad> quads;

  Index count() const { return static_cast<Index>(3 * triangles.size() + 4 * quads.size()); }
  HalfEdge operator[](Index h) const {
    const Index quad_begin = static_cast<Index>(3 * triangles.size());
    if (h < quad_begin) {
      const Triangle& t = triangles[static_cast<std::size_t>(h / 3)];
      const int k = h % 3;
      return {t[k == 2 ? 0 : k + 1], t[k == 0 ? 2 : k - 1]};
    }
    const Quad& q = quads[static_cast<std::size_t>((h - quad_begin) / 4)];
    const int k = (h - quad_begin) % 4;
    return {q[k], q[k == 3 ? 0 : k + 1]};
  }
  /// Element that owns h, numbered like VertexStars: triangles first, then quads.
  Index element(Index h) const {
    const Index quad_begin = static_cast<Index>(3 * triangles.size());
    if (h < quad_begin) return h / 3;
    return static_cast<Index>(triangles.size()) + (h - quad_begin) / 4;
  }
};
inline HalfEdges half_edges(const Mesh& mesh) { return {mesh.triangles, mesh.quads}; }

/// Two half-edges between the same vertices that cannot be twins.
struct EdgeConflict {
  Index first = kNoIndex;      ///< half-edge seen first
  Index second = kNoIndex;     ///< half-edge that does not fit
  bool same_direction = true;  ///< else: a third element at one edge
};

/// twin[h] is the half-edge on the other side of h, or kNoIndex on the boundary.
struct HalfEdgeTwins {
  std::vector<Index> twin;
  std::vector<EdgeConflict> conflicts;  ///< empty for a conforming mesh
};

/// Law: twin[twin[h]] == h, and twins run in opposite directions. O(n).
/// Precondition: all vertex numbers lie in 0 .. vertex_count - 1.
HalfEdgeTwins half_edge_twins(const HalfEdges& edges, Index vertex_count);

/// Every edge of the mesh once, as ordered vertex pairs (smaller index first), in the order of
/// the elements that hold them: triangles, then quads. This and the functions below need vertex
/// numbers in range; an edge of conflicting elements (see half_edge_twins) comes more than once.
std::vector<std::array<Index, 2>> mesh_edges(const Mesh& mesh);

/// Directed edges that belong to one element only (element on the left), in element order.
std::vector<std::array<Index, 2>> boundary_edges(const Mesh& mesh);

/// Vertex -> incident elements in compressed form: those of vertex v are
/// elements[first[v]] .. elements[first[v + 1] - 1], ascending; element e < triangles.size() is a
/// triangle, else quad e - triangles.size().
struct VertexStars {
  std::vector<Index> first;
  std::vector<Index> elements;
};
VertexStars vertex_stars(const Mesh& mesh);

/// Vertex -> neighbouring vertices along edges, compressed like VertexStars; each neighbour once,
/// in the order of mesh_edges().
struct VertexNeighbours {
  std::vector<Index> first;
  std::vector<Index> vertices;
};
VertexNeighbours vertex_neighbours(const Mesh& mesh);

}  // namespace anisofront
