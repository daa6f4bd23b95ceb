#include "mesher/quads/block_matching.hpp"

#include <random>

#include <doctest/doctest.h>

#include "mesher/quads/pairing_candidates.hpp"
#include "tests/mesher/quads/pairing_support.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

std::vector<WeightedPair> random_weights(const WorkMesh& mesh, std::mt19937_64& random) {
  std::vector<WeightedPair> pairs;
  for (const MergeCandidate& c : merge_candidates(mesh))
    pairs.push_back({c.first, c.second, std::uniform_int_distribution<int>(500, 1000)(random)});
  return pairs;
}

/// Sum of the weights; -1 when mates are not mutual or no pair joins them.
std::int64_t weight_of(const std::vector<Index>& mates, const std::vector<WeightedPair>& pairs) {
  std::int64_t sum = 0;
  std::size_t paired = 0;
  for (const WeightedPair& p : pairs)
    if (mates[p.first] == p.second && mates[p.second] == p.first) {
      sum += p.weight;
      paired += 2;
    }
  for (const Index m : mates) paired -= m == kNoIndex ? 0 : 1;
  return paired == 0 ? sum : -1;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("one block is matched exactly") {
    std::mt19937_64 random(2);
    const WorkMesh mesh = right_triangles(6, 5);
    const std::vector<WeightedPair> pairs = random_weights(mesh, random);
    CHECK(match_in_blocks(mesh, pairs, 60) == maximum_weight_matching(60, pairs));
  }

  TEST_CASE("dead triangles have no mate") {
    WorkMesh mesh = right_triangles(2, 1);
    for (const Index t : {2, 3}) mesh.triangles[t] = {};
    CHECK(match_in_blocks(mesh, {{0, 1, 5}}, 2) == std::vector<Index>{1, 0, kNoIndex, kNoIndex});
    CHECK(match_in_blocks({}, {}).empty());
  }
}

TEST_SUITE("property") {
  TEST_CASE("blocks lose little of the largest weight and the smaller the more") {
    std::mt19937_64 random(13);
    const WorkMesh mesh = right_triangles(40, 30);
    const std::vector<WeightedPair> pairs = random_weights(mesh, random);
    const auto weight = [&](std::size_t block) {
      return static_cast<double>(weight_of(match_in_blocks(mesh, pairs, block), pairs));
    };
    const double largest = weight(2400);
    for (const std::size_t block : {1000, 600, 300}) {
      CHECK(weight(block) <= largest);
      CHECK(weight(block) > 0.99 * largest);
    }
    CHECK(weight(100) > 0.98 * largest);
    CHECK(weight(2) > 0);
  }
}
