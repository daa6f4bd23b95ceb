#pragma once

#include <vector>

#include "solver/system/assemble.hpp"

namespace anisofront {

/// Which nodes (vertices, then edges, that carry unknowns) share an element: the pattern of the
/// matrix in blocks. A node is its own neighbour; neighbours ascend, so vertices come first.
struct NodeGraph {
  std::vector<std::int64_t> first;  ///< neighbours of n: first[n] .. first[n + 1] - 1
  std::vector<Index> neighbours;
  std::vector<Index> vertex_count;  ///< neighbours of n that are vertices
};

/// Nodes of an element in local order: corners (when vertices carry unknowns), then edges (when
/// they do); edge e is node vertices + e.
struct ElementNodes {
  std::array<Index, 8> numbers{};
  int count = 0;
};
ElementNodes element_nodes(const DofMap& dofs, const Element& element);

/// O(n), on all cores.
NodeGraph node_graph(const FeMesh& mesh, const DofMap& dofs, int threads);

/// The zero matrix of that pattern: each block of two neighbours is full.
SparseMatrix zero_matrix(const NodeGraph& graph, const DofMap& dofs);

}  // namespace anisofront
