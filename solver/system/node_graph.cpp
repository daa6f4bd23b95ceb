#include "solver/system/node_graph.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

/// Node -> elements around it, compressed, ascending.
struct NodeStars {
  std::vector<Index> first, elements;
};

NodeStars node_stars(const FeMesh& mesh, const DofMap& dofs) {
  NodeStars stars;
  stars.first.assign(static_cast<std::size_t>(dofs.vertices + dofs.edges) + 1, 0);
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const ElementNodes nodes = element_nodes(dofs, element_at(mesh, e));
    for (int k = 0; k < nodes.count; ++k) ++stars.first[nodes.numbers[k] + 1];
  }
  std::partial_sum(stars.first.begin(), stars.first.end(), stars.first.begin());
  stars.elements.resize(stars.first.back());
  std::vector<Index> next(stars.first.begin(), stars.first.end() - 1);
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const ElementNodes nodes = element_nodes(dofs, element_at(mesh, e));
    for (int k = 0; k < nodes.count; ++k) stars.elements[next[nodes.numbers[k]]++] = e;
  }
  return stars;
}

/// Replaces `found` by the nodes of the elements around `node`, each once.
void collect_neighbours(const FeMesh& mesh, const DofMap& dofs, const NodeStars& stars, Index node,
                        std::vector<Index>& found) {
  found.clear();
  for (Index i = stars.first[node]; i < stars.first[node + 1]; ++i) {
    const ElementNodes nodes = element_nodes(dofs, element_at(mesh, stars.elements[i]));
    found.insert(found.end(), nodes.numbers.begin(), nodes.numbers.begin() + nodes.count);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

int unknowns_of(const DofMap& dofs, Index node) {
  return node < dofs.vertices ? dofs.layout.per_vertex : dofs.layout.per_edge;
}

Index first_unknown(const DofMap& dofs, Index node) {
  return node < dofs.vertices ? dofs.at_vertex(node) : dofs.at_edge(node - dofs.vertices);
}

}  // namespace

ElementNodes element_nodes(const DofMap& dofs, const Element& element) {
  ElementNodes nodes;
  if (dofs.layout.per_vertex > 0)
    for (int k = 0; k < element.corners; ++k) nodes.numbers[nodes.count++] = element.vertices[k];
  if (dofs.layout.per_edge > 0)
    for (int k = 0; k < element.corners; ++k)
      nodes.numbers[nodes.count++] = dofs.vertices + element.edges[k];
  return nodes;
}

NodeGraph node_graph(const FeMesh& mesh, const DofMap& dofs, int threads) {
  const NodeStars stars = node_stars(mesh, dofs);
  const Index nodes = dofs.vertices + dofs.edges;
  NodeGraph graph;
  graph.first.assign(static_cast<std::size_t>(nodes) + 1, 0);
  graph.vertex_count.assign(nodes, 0);
#pragma omp parallel num_threads(threads)
  {
    std::vector<Index> found;
#pragma omp for schedule(static)
    for (Index n = 0; n < nodes; ++n) {
      collect_neighbours(mesh, dofs, stars, n, found);
      graph.first[n + 1] = static_cast<std::int64_t>(found.size());
    }
#pragma omp single
    {
      std::partial_sum(graph.first.begin(), graph.first.end(), graph.first.begin());
      graph.neighbours.resize(static_cast<std::size_t>(graph.first.back()));
    }
#pragma omp for schedule(static)
    for (Index n = 0; n < nodes; ++n) {
      collect_neighbours(mesh, dofs, stars, n, found);
      std::copy(found.begin(), found.end(), graph.neighbours.begin() + graph.first[n]);
      graph.vertex_count[n] = static_cast<Index>(
          std::lower_bound(found.begin(), found.end(), dofs.vertices) - found.begin());
    }
  }
  return graph;
}

SparseMatrix zero_matrix(const NodeGraph& graph, const DofMap& dofs) {
  const Index unknowns = dofs.count(), nodes = dofs.vertices + dofs.edges;
  std::int64_t entries = 0;
  SparseMatrix matrix(unknowns, unknowns);
  Index* outer = matrix.outerIndexPtr();
  for (Index n = 0; n < nodes; ++n) {
    const std::int64_t vertices = graph.vertex_count[n];
    const std::int64_t edges = graph.first[n + 1] - graph.first[n] - vertices;
    const std::int64_t height = vertices * dofs.layout.per_vertex + edges * dofs.layout.per_edge;
    for (int c = 0; c < unknowns_of(dofs, n); ++c) {
      outer[first_unknown(dofs, n) + c] = static_cast<Index>(entries);
      entries += height;
    }
    if (entries > std::numeric_limits<Index>::max())
      throw BudgetError("the matrix of " + std::to_string(unknowns) +
                        " unknowns has more than 2^31 entries; use a coarser mesh");
  }
  outer[unknowns] = static_cast<Index>(entries);
  matrix.resizeNonZeros(static_cast<Index>(entries));
  std::fill_n(matrix.valuePtr(), entries, 0.);
  for (Index n = 0; n < nodes; ++n)
    for (int c = 0; c < unknowns_of(dofs, n); ++c) {
      Index* row = matrix.innerIndexPtr() + outer[first_unknown(dofs, n) + c];
      for (std::int64_t i = graph.first[n]; i < graph.first[n + 1]; ++i) {
        const Index neighbour = graph.neighbours[i];
        for (int d = 0; d < unknowns_of(dofs, neighbour); ++d)
          *row++ = first_unknown(dofs, neighbour) + d;
      }
    }
  return matrix;
}

}  // namespace anisofront
