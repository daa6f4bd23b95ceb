#include "mesher/mesh/curve_chains.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace anisofront::detail {
namespace {

Index other_end(const SidedEdge& edge, Index v) {
  return edge.vertices[edge.vertices[0] == v ? 1 : 0];
}

Index first_edge(const Chain& chain) {
  return *std::min_element(chain.edges.begin(), chain.edges.end());
}

/// Vertex -> curve edges in compressed form.
struct EdgeStars {
  std::vector<Index> first;
  std::vector<Index> edges;

  Index count(std::size_t v) const { return first[v + 1] - first[v]; }
  Index edge(Index v, Index k) const {
    return edges[static_cast<std::size_t>(first[static_cast<std::size_t>(v)] + k)];
  }
};

EdgeStars edge_stars(std::size_t vertex_count, const std::vector<SidedEdge>& edges) {
  EdgeStars stars{std::vector<Index>(vertex_count + 2, 0), std::vector<Index>(2 * edges.size())};
  for (const SidedEdge& edge : edges)
    for (const Index v : edge.vertices) ++stars.first[static_cast<std::size_t>(v) + 2];
  std::partial_sum(stars.first.begin(), stars.first.end(), stars.first.begin());
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const Index v : edges[e].vertices) {
      Index& next = stars.first[static_cast<std::size_t>(v) + 1];
      stars.edges[static_cast<std::size_t>(next++)] = static_cast<Index>(e);
    }
  stars.first.pop_back();
  return stars;
}

class ChainBuilder {
 public:
  ChainBuilder(const Mesh& mesh, const std::vector<SidedEdge>& edges,
               const std::vector<char>& required, double corner_angle)
      : mesh_(mesh),
        edges_(edges),
        stars_(edge_stars(mesh.points.size(), edges)),
        is_corner_(mesh.points.size(), 0),
        is_break_(required),
        used_(edges.size(), 0) {
    for (const Index v : mesh.corners) is_corner_.at(static_cast<std::size_t>(v)) = 1;
    const double least_cosine = std::cos(corner_angle * std::numbers::pi / 180);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (stars_.count(v) > 0) classify(v, least_cosine);
  }

  std::vector<Chain> build() {
    // Open chains from a start vertex, then those whose edges do not all run one way, then loops.
    for (const std::size_t end : {0, 1})
      for (std::size_t e = 0; e < edges_.size(); ++e)
        if (!used_[e] && is_break_[static_cast<std::size_t>(edges_[e].vertices[end])])
          walk(static_cast<Index>(e), end == 1);
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (!used_[e]) walk(static_cast<Index>(e), false);
    std::sort(chains_.begin(), chains_.end(),
              [](const Chain& a, const Chain& b) { return first_edge(a) < first_edge(b); });
    return std::move(chains_);
  }

 private:
  const SidedEdge& edge(Index e) const { return edges_[static_cast<std::size_t>(e)]; }
  Point point(Index v) const { return mesh_.points[static_cast<std::size_t>(v)]; }

  void classify(std::size_t vertex, double least_cosine) {
    const auto v = static_cast<Index>(vertex);
    if (stars_.count(vertex) != 2) {
      is_corner_[vertex] = is_break_[vertex] = 1;
      return;
    }
    const SidedEdge &a = edge(stars_.edge(v, 0)), &b = edge(stars_.edge(v, 1));
    const Vector in = point(v) - point(other_end(a, v)), out = point(other_end(b, v)) - point(v);
    if (dot(in, out) < least_cosine * norm(in) * norm(out)) is_corner_[vertex] = 1;
    if (is_corner_[vertex] || a.tag != b.tag) is_break_[vertex] = 1;
  }

  /// Follows the curve from edge `e`, entered at its second vertex when `backwards`, to the next
  /// break or round to the start.
  void walk(Index e, bool backwards) {
    const SidedEdge& start = edge(e);
    Chain chain;
    chain.tag = start.tag;
    chain.left = backwards ? start.right : start.left;
    chain.right = backwards ? start.left : start.right;
    const Index first = start.vertices[backwards ? 1 : 0];
    chain.vertices.push_back(first);
    for (Index v = first;;) {
      used_[static_cast<std::size_t>(e)] = 1;
      v = other_end(edge(e), v);
      chain.edges.push_back(e);
      chain.vertices.push_back(v);
      if (v == first || is_break_[static_cast<std::size_t>(v)]) break;
      e = stars_.edge(v, stars_.edge(v, 0) == e ? 1 : 0);
    }
    chain.smooth_seam =
        chain.vertices.back() == first && !is_corner_[static_cast<std::size_t>(first)];
    chains_.push_back(std::move(chain));
  }

  const Mesh& mesh_;
  const std::vector<SidedEdge>& edges_;
  EdgeStars stars_;
  std::vector<char> is_corner_;  ///< no common tangent on both sides
  std::vector<char> is_break_;
  std::vector<char> used_;
  std::vector<Chain> chains_;
};

}  // namespace

std::vector<Chain> chain_edges(const Mesh& mesh, const std::vector<SidedEdge>& edges,
                               const std::vector<char>& required, double corner_angle) {
  return ChainBuilder(mesh, edges, required, corner_angle).build();
}

}  // namespace anisofront::detail
