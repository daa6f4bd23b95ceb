// The only file that knows LEMON, and compiled as C++17: LEMON 1.3.1 calls members of
// std::allocator that C++20 has removed.
#include "mesher/quads/matching.hpp"

#define LEMON_ONLY_TEMPLATES  // the library itself need not be linked
#include <lemon/matching.h>
#include <lemon/smart_graph.h>

namespace anisofront {

std::vector<std::int32_t> maximum_weight_matching(std::int32_t nodes,
                                                  const std::vector<WeightedPair>& pairs) {
  using Graph = lemon::SmartGraph;
  using Weights = Graph::EdgeMap<std::int64_t>;
  Graph graph;
  graph.reserveNode(nodes);
  graph.reserveEdge(static_cast<int>(pairs.size()));
  for (std::int32_t i = 0; i < nodes; ++i) graph.addNode();
  Weights weights(graph);
  for (const WeightedPair& pair : pairs)
    weights[graph.addEdge(Graph::nodeFromId(pair.first), Graph::nodeFromId(pair.second))] =
        pair.weight;
  lemon::MaxWeightedMatching<Graph, Weights> matching(graph, weights);
  matching.run();
  std::vector<std::int32_t> mates(static_cast<std::size_t>(nodes));
  for (std::int32_t i = 0; i < nodes; ++i)
    mates[static_cast<std::size_t>(i)] = Graph::id(matching.mate(Graph::nodeFromId(i)));
  return mates;
}

}  // namespace anisofront
