#pragma once

#include <cstdint>
#include <vector>

// Also read as C++17, by matching.cpp: hence no project header and std::int32_t for Index.

namespace anisofront {

/// Two different nodes that may be matched. A pair of weight <= 0 is never worth it.
struct WeightedPair {
  std::int32_t first = -1;
  std::int32_t second = -1;
  std::int64_t weight = 0;  ///< at most 2^40; integers make the result exact
};

/// Per node 0 .. nodes - 1 its mate, or kNoIndex (-1): no two pairs share a node and the sum of the
/// weights is the largest possible. Deterministic. About O(n log n) on triangle meshes, where a
/// node has at most three pairs.
/// Reference: J. Edmonds, Paths, trees, and flowers, Canad. J. Math. 17 (1965),
/// doi:10.4153/CJM-1965-045-4; the implementation is LEMON's.
std::vector<std::int32_t> maximum_weight_matching(std::int32_t nodes,
                                                  const std::vector<WeightedPair>& pairs);

}  // namespace anisofront
