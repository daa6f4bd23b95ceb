#include "solver/space/edge_numbering.hpp"

#include <algorithm>
#include <string>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/topology.hpp"

namespace anisofront {
namespace {

/// The edge of each half-edge; a pair of twins is numbered when its first is met.
std::vector<Index> edges_of_half_edges(const Mesh& mesh, EdgeNumbering& numbering) {
  const HalfEdges half = half_edges(mesh);
  const auto twins = half_edge_twins(half, static_cast<Index>(mesh.points.size())).twin;
  std::vector<Index> edge_of(twins.size());
  for (Index h = 0; h < half.count(); ++h) {
    if (twins[h] != kNoIndex && twins[h] < h) {
      edge_of[h] = edge_of[twins[h]];
      continue;
    }
    edge_of[h] = numbering.count();
    const auto [from, to] = half[h];
    numbering.vertices.push_back({std::min(from, to), std::max(from, to)});
  }
  return edge_of;
}

/// Half-edge 3 t + k lies opposite corner k, so it is edge k + 1 of its triangle.
void set_element_edges(const Mesh& mesh, const std::vector<Index>& edge_of,
                       EdgeNumbering& numbering) {
  numbering.triangle_edges.resize(mesh.triangles.size());
  numbering.quad_edges.resize(mesh.quads.size());
  std::size_t h = 0;
  for (auto& edges : numbering.triangle_edges)
    for (int k = 0; k < 3; ++k) edges[(k + 1) % 3] = edge_of[h++];
  for (auto& edges : numbering.quad_edges)
    for (int k = 0; k < 4; ++k) edges[k] = edge_of[h++];
}

using NumberedEdge = std::pair<std::array<Index, 2>, Index>;

void find_curve_edges(const Mesh& mesh, EdgeNumbering& numbering) {
  std::vector<char> on_curve(mesh.points.size(), 0);
  for (const CurveEdge& edge : mesh.edges)
    for (const Index v : edge.vertices) on_curve[v] = 1;
  std::vector<NumberedEdge> candidates;
  for (Index e = 0; e < numbering.count(); ++e) {
    const auto& [a, b] = numbering.vertices[e];
    if (on_curve[a] && on_curve[b]) candidates.push_back({{a, b}, e});
  }
  std::sort(candidates.begin(), candidates.end());
  for (const CurveEdge& edge : mesh.edges) {
    const std::array<Index, 2> key{std::min(edge.vertices[0], edge.vertices[1]),
                                   std::max(edge.vertices[0], edge.vertices[1])};
    const auto found = std::lower_bound(candidates.begin(), candidates.end(), NumberedEdge{key, 0});
    if (found == candidates.end() || found->first != key)
      throw InputError("the curve edge between vertices " + std::to_string(key[0] + 1) + " and " +
                       std::to_string(key[1] + 1) +
                       " is no edge of an element; check the mesh with `anisofront check`");
    numbering.curve_edges.push_back(found->second);
  }
}

}  // namespace

EdgeNumbering number_edges(const Mesh& mesh) {
  EdgeNumbering numbering;
  const auto edge_of = edges_of_half_edges(mesh, numbering);
  set_element_edges(mesh, edge_of, numbering);
  find_curve_edges(mesh, numbering);
  return numbering;
}

}  // namespace anisofront
