#pragma once

#include <array>
#include <vector>

#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// The edges of a mesh, numbered in the order of mesh_edges().
struct EdgeNumbering {
  std::vector<std::array<Index, 2>> vertices;        ///< of each edge, the smaller first
  std::vector<std::array<Index, 3>> triangle_edges;  ///< edge k joins corners k and k + 1
  std::vector<std::array<Index, 4>> quad_edges;      ///< edge k joins corners k and k + 1
  std::vector<Index> curve_edges;                    ///< edge of each entry of Mesh::edges

  Index count() const { return static_cast<Index>(vertices.size()); }
};

/// O(n). Throws InputError naming the vertices of a curve edge that no element has.
/// Precondition: vertex numbers in range.
EdgeNumbering number_edges(const Mesh& mesh);

}  // namespace anisofront
