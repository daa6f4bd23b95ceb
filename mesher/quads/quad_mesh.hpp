#pragma once

#include <cstdint>
#include <vector>

#include "mesher/quads/mixed_mesh.hpp"

namespace anisofront {

enum class QuadVertexKind : std::uint8_t {
  free,
  boundary,  ///< on a segment: never moved or removed
  required,  ///< a point of the domain inside a region: never moved or removed
};

/// A pure quadrilateral mesh under improvement, as half-edges: h = 4 q + k runs from corner k of
/// quad q to corner k + 1 with the quad on its left.
///
/// The mesh is cut open along its segments: a vertex on an interface or an embedded curve has one
/// copy on each side, so that every vertex has one ring or one fan of quadrilaterals and no
/// operation can reach across a segment.
struct QuadMesh {
  std::vector<WorkVertex> vertices;
  std::vector<Index> corner;          ///< per half-edge: the vertex it leaves; kNoIndex: dead quad
  std::vector<Index> twin;            ///< per half-edge: the opposite one, or ~segment
  std::vector<Index> leaving;         ///< per vertex: a half-edge that leaves it, the first
                                      ///< anticlockwise of a fan; kNoIndex: removed
  std::vector<std::uint8_t> valence;  ///< per vertex: number of its quadrilaterals
  std::vector<QuadVertexKind> kind;   ///< per vertex
  std::vector<Index> original;        ///< per vertex: that of which it is a copy, or kNoIndex
  std::vector<Index> next_copy;       ///< per vertex: the copies of one vertex form a circle

  Index quad_count() const { return static_cast<Index>(corner.size() / 4); }
  bool is_dead(Index quad) const { return corner[4 * static_cast<std::size_t>(quad)] == kNoIndex; }
  bool is_free(Index v) const { return kind[v] == QuadVertexKind::free; }
  bool on_boundary(Index v) const { return kind[v] == QuadVertexKind::boundary; }
  const WorkVertex& vertex_at(Index h) const { return vertices[corner[h]]; }
};

/// The half-edges after and before h in its quadrilateral, and the quadrilateral.
inline Index next_in_quad(Index h) { return (h & ~3) | ((h + 1) & 3); }
inline Index opposite_in_quad(Index h) { return h ^ 2; }
inline Index previous_in_quad(Index h) { return (h & ~3) | ((h + 3) & 3); }
inline Index quad_of(Index h) { return h >> 2; }

/// The half-edge that leaves the same vertex next anticlockwise (clockwise), or ~segment.
inline Index anticlockwise(const QuadMesh& mesh, Index h) { return mesh.twin[previous_in_quad(h)]; }
inline Index clockwise(const QuadMesh& mesh, Index h) {
  return mesh.twin[h] < 0 ? mesh.twin[h] : next_in_quad(mesh.twin[h]);
}

/// Calls visit(h) for every half-edge that leaves v, anticlockwise.
template <class Visit>
void for_each_leaving(const QuadMesh& mesh, Index v, Visit&& visit) {
  const Index first = mesh.leaving[v];
  Index h = first;
  do {
    visit(h);
    h = anticlockwise(mesh, h);
  } while (h >= 0 && h != first);
}

/// Whether u and v are copies of one vertex.
inline bool is_same(const QuadMesh& mesh, Index u, Index v) {
  return u == v || (mesh.original[u] != kNoIndex && mesh.original[u] == mesh.original[v]);
}

/// Whether a mesh edge joins copies of u and v.
bool are_adjacent(const QuadMesh& mesh, Index u, Index v);

/// Cuts the mesh open along its segments. Precondition: `mesh` has quadrilaterals only and is
/// conforming. Throws MeshingError where more than 255 quadrilaterals meet in a vertex.
QuadMesh make_quad_mesh(const MixedMesh& mesh);

/// Glues the mesh together again: old vertices keep their numbers, new ones follow; `segments` are
/// those it was cut along.
MixedMesh glued(const QuadMesh& mesh, std::vector<Segment> segments);

}  // namespace anisofront
