#include "mesher/quads/matching.hpp"

#include <algorithm>
#include <random>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

using Mates = std::vector<std::int32_t>;

std::int64_t weight_of(const Mates& mates, const std::vector<WeightedPair>& pairs) {
  std::int64_t sum = 0;
  for (const WeightedPair& p : pairs)
    if (mates[static_cast<std::size_t>(p.first)] == p.second) sum += p.weight;
  return sum;
}

/// The largest weight by trying every subset of pairs that share no node.
std::int64_t best_weight(const std::vector<WeightedPair>& pairs, std::size_t next, unsigned used) {
  if (next == pairs.size()) return 0;
  const std::int64_t without = best_weight(pairs, next + 1, used);
  const WeightedPair& p = pairs[next];
  const unsigned both = 1u << p.first | 1u << p.second;
  if (used & both) return without;
  return std::max(without, p.weight + best_weight(pairs, next + 1, used | both));
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("nodes without pairs stay alone") {
    CHECK(maximum_weight_matching(0, {}).empty());
    CHECK(maximum_weight_matching(3, {}) == Mates{-1, -1, -1});
    CHECK(maximum_weight_matching(3, {{2, 0, 7}}) == Mates{2, -1, 0});
  }

  TEST_CASE("two outer pairs beat the heavier middle one") {
    CHECK(maximum_weight_matching(4, {{0, 1, 6}, {1, 2, 10}, {2, 3, 6}}) == Mates{1, 0, 3, 2});
    CHECK(maximum_weight_matching(4, {{0, 1, 4}, {1, 2, 10}, {2, 3, 4}}) == Mates{-1, 2, 1, -1});
  }

  TEST_CASE("an odd cycle leaves one node and gives up its lightest pairs") {
    const std::vector<WeightedPair> pentagon{{0, 1, 8}, {1, 2, 9}, {2, 3, 3}, {3, 4, 9}, {4, 0, 2}};
    CHECK(maximum_weight_matching(5, pentagon) == Mates{-1, 2, 1, 4, 3});
  }

  TEST_CASE("pairs that are worth nothing are not made") {
    CHECK(maximum_weight_matching(2, {{0, 1, -5}}) == Mates{-1, -1});
  }
}

TEST_SUITE("property") {
  TEST_CASE("random graphs are matched as well as by trying everything") {
    std::mt19937 random(7);
    const auto pick = [&](int low, int high) {
      return std::uniform_int_distribution<int>(low, high)(random);
    };
    for (int i = 0; i < 300; ++i) {
      const int nodes = pick(2, 10);
      std::vector<WeightedPair> pairs;
      for (int a = 0; a < nodes; ++a)
        for (int b = a + 1; b < nodes; ++b)
          if (pairs.size() < 16 && pick(0, 2) == 0) pairs.push_back({a, b, pick(500, 1000)});
      const Mates mates = maximum_weight_matching(nodes, pairs);
      CHECK(weight_of(mates, pairs) == best_weight(pairs, 0, 0));
      for (int a = 0; a < nodes; ++a) {
        const std::int32_t b = mates[static_cast<std::size_t>(a)];
        if (b >= 0) CHECK(mates[static_cast<std::size_t>(b)] == a);
      }
      CHECK(maximum_weight_matching(nodes, pairs) == mates);
    }
  }
}
