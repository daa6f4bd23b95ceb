#include "mesher/io/svg_outline.hpp"

#include "mesher/mesh/topology.hpp"

namespace anisofront {

namespace {

/// Directed edges from each vertex.
using EdgesFrom = std::multimap<Index, Index>;

/// Goes along the edges until none leads on; as many end as begin at every vertex, so that this is
/// where the loop began.
std::vector<Index> take_loop(EdgesFrom& edges) {
  std::vector<Index> loop;
  for (auto edge = edges.begin(); edge != edges.end(); edge = edges.find(loop.back())) {
    if (loop.empty()) loop.push_back(edge->first);
    loop.push_back(edge->second);
    edges.erase(edge);
  }
  loop.pop_back();
  return loop;
}

}  // namespace

std::map<Index, Loops> class_outlines(const Mesh& mesh, std::span<const Index> classes) {
  const HalfEdges halves = half_edges(mesh);
  const std::vector<Index> twin =
      half_edge_twins(halves, static_cast<Index>(mesh.points.size())).twin;
  const auto class_of = [&](Index half) {
    return classes[static_cast<std::size_t>(halves.element(half))];
  };
  std::map<Index, EdgesFrom> borders;
  for (Index h = 0; h < halves.count(); ++h) {
    const Index other = twin[static_cast<std::size_t>(h)];
    if (class_of(h) >= 0 && (other == kNoIndex || class_of(other) != class_of(h)))
      borders[class_of(h)].emplace(halves[h].from, halves[h].to);
  }
  std::map<Index, Loops> outlines;
  for (auto& [number, edges] : borders)
    while (!edges.empty()) outlines[number].push_back(take_loop(edges));
  return outlines;
}

}  // namespace anisofront
