#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesher/quads/mixed_mesh.hpp"

namespace anisofront {

/// An edge of a mixed mesh, from a to b as its left face runs through it. `right` is kNoIndex on
/// the boundary, `segment` inside a region.
struct MixedEdge {
  Index a = kNoIndex, b = kNoIndex;
  Index left = kNoIndex, right = kNoIndex;
  Index segment = kNoIndex;
};

/// Every edge once, in the order of the faces; of_face[f][k] is the edge from vertex k of face f to
/// the next one.
struct MixedEdges {
  std::vector<MixedEdge> edges;
  std::vector<std::array<Index, 4>> of_face;
};

/// O(n). Throws MeshingError naming the vertices of an edge that does not lie between two faces.
MixedEdges mixed_edges(const MixedMesh& mesh);

/// A face at one of its vertices.
struct Corner {
  Index face = kNoIndex;
  int k = 0;  ///< position of the vertex in the face
};

/// Vertex -> faces in compressed form: those of vertex v are corners[first[v]] ..
/// corners[first[v + 1] - 1], in the order of the faces.
struct FaceStars {
  std::vector<Index> first;
  std::vector<Corner> corners;

  std::span<const Corner> operator[](Index v) const {
    return {corners.data() + first[v], corners.data() + first[v + 1]};
  }
};
FaceStars face_stars(const MixedMesh& mesh);

/// The k-th vertex of the face, counted cyclically (0 <= k < 2 size).
inline Index vertex_at(const MixedFace& face, int k) {
  return face.vertices[k < face.size() ? k : k - face.size()];
}

/// Per vertex: on a segment or required, never moved.
std::vector<char> fixed_vertices(const MixedMesh& mesh);

Index triangle_count(const MixedMesh& mesh);

}  // namespace anisofront
