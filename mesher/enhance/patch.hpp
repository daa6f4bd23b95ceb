#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesher/background/background_mesh.hpp"
#include "mesher/front/work_mesh.hpp"

namespace anisofront {

struct EnhanceStatistics {
  std::int64_t swaps = 0, moves = 0, collapses = 0, splits = 0;
};

/// The mesh under improvement with what its operations need to know.
struct Patch {
  const BackgroundMesh& background;
  WorkMesh& mesh;
  std::vector<Index> triangle_of;  ///< per vertex: one of its triangles; kNoIndex when removed
  std::vector<char> fixed;         ///< per vertex: on a segment or required, never moved
  std::vector<char> active;        ///< per vertex: its surroundings have changed
  std::vector<float> alpha;        ///< per triangle: mean_alpha
  EnhanceStatistics statistics;

  const WorkVertex& vertex(Index v) const { return mesh.vertices[v]; }
  Point point(Index v) const { return mesh.vertices[v].p; }
  double alpha_of(Index a, Index b, Index c) const {
    return mean_alpha(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
  }
  double alpha_of(Index triangle) const {
    const auto& v = mesh.triangles[triangle].vertices;
    return alpha_of(v[0], v[1], v[2]);
  }
  void update_alpha(Index triangle) { alpha[triangle] = static_cast<float>(alpha_of(triangle)); }
  void update_all_alphas();
  void activate(Index triangle) {
    for (const Index v : mesh.triangles[triangle].vertices) active[v] = 1;
  }
};

/// All vertices active, those on segments and `required` fixed.
Patch make_patch(const BackgroundMesh& background, WorkMesh& mesh,
                 const std::vector<Index>& required);

/// Position of vertex v in the triangle.
inline int local_index(const WorkTriangle& t, Index v) {
  return t.vertices[0] == v ? 0 : t.vertices[1] == v ? 1 : 2;
}

/// Position of neighbour u in the triangle.
inline int side_towards(const WorkTriangle& t, Index u) {
  return t.neighbours[0] == u ? 0 : t.neighbours[1] == u ? 1 : 2;
}

/// Replaces `before` by `after` among the neighbours of t; nothing when t is a segment.
inline void replace_neighbour(WorkMesh& mesh, Index t, Index before, Index after) {
  if (t < 0) return;
  auto& n = mesh.triangles[t].neighbours;
  n[n[0] == before ? 0 : n[1] == before ? 1 : 2] = after;
}

/// The triangles around a vertex, anticlockwise, and their outer vertices: vertices[i],
/// vertices[i + 1] are those of triangles[i]. A closed ring has as many vertices as triangles (and
/// its first vertex once more at the end), a fan between segments one more.
struct Ring {
  static constexpr int kCapacity = 62;
  int size = 0;  ///< number of triangles
  bool closed = false;
  std::array<Index, kCapacity + 1> vertices;
  std::array<Index, kCapacity> triangles;
  int vertex_count() const { return closed ? size : size + 1; }
};

/// Ring of an interior vertex; false when it is cut by segments or larger than the capacity.
bool closed_ring(const Patch& patch, Index v, Ring& ring);

/// The ring or fan of v that contains the triangle; false when it is larger than the capacity.
bool fan_through(const Patch& patch, Index v, Index triangle, Ring& ring);

}  // namespace anisofront
