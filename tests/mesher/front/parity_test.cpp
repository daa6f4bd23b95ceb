#include "mesher/front/parity.hpp"

#include <algorithm>
#include <random>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

/// Parts whose parity the changes flip, ascending.
std::vector<Index> flipped(const std::vector<ParityLink>& links, Index parts,
                           const std::vector<Index>& changes) {
  std::vector<int> count(parts, 0);
  for (const Index i : changes)
    for (const Index part : {links[i].left, links[i].right})
      if (part != kNoIndex) ++count[part];
  std::vector<Index> odd;
  for (Index part = 0; part < parts; ++part)
    if (count[part] % 2) odd.push_back(part);
  return odd;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("nothing changes where nothing is odd") {
    CHECK(cheapest_parity_changes({{0, kNoIndex, 1}}, 1, {}).empty());
  }

  TEST_CASE("one odd part changes its cheapest link to the outside") {
    const std::vector<ParityLink> links{{0, kNoIndex, 3}, {kNoIndex, 0, 2}, {0, 0, 1}};
    CHECK(cheapest_parity_changes(links, 1, {0}) == std::vector<Index>{1});
  }

  TEST_CASE("two odd parts share the link between them when it is cheaper") {
    const auto changes = [](double between) {
      const std::vector<ParityLink> links{{0, kNoIndex, 3}, {0, 1, between}, {1, kNoIndex, 4}};
      return cheapest_parity_changes(links, 2, {0, 1});
    };
    CHECK(changes(2.5) == std::vector<Index>{1});
    CHECK(changes(9) == std::vector<Index>{0, 2});
  }

  TEST_CASE("a part without outside is led through its neighbours") {
    // A row of three, only the last touches the outside; the chain has two links.
    const std::vector<ParityLink> links{{0, 1, 1}, {1, 2, 1}, {2, kNoIndex, 1}};
    CHECK(cheapest_parity_changes(links, 3, {1}) == std::vector<Index>{1, 2});
    CHECK(cheapest_parity_changes(links, 3, {0, 2}) == std::vector<Index>{0, 1});
  }

  TEST_CASE("random graphs always end with just the wanted parities flipped") {
    std::mt19937_64 random(1);
    for (int i = 0; i < 300; ++i) {
      const auto parts = std::uniform_int_distribution<Index>(1, 12)(random);
      std::uniform_int_distribution<Index> part(0, parts - 1);
      std::vector<ParityLink> links;
      for (Index p = 1; p < parts; ++p)  // a tree with the outside at part 0
        links.push_back({p, std::uniform_int_distribution<Index>(0, p - 1)(random),
                         std::uniform_real_distribution<double>(0, 1)(random)});
      links.push_back({kNoIndex, 0, 5});
      for (int k = 0; k < 8; ++k)
        links.push_back({part(random), k % 4 ? part(random) : kNoIndex,
                         std::uniform_real_distribution<double>(0, 1)(random)});
      std::vector<Index> odd;
      for (Index p = 0; p < parts; ++p)
        if (random() % 2) odd.push_back(p);
      const std::vector<Index> changes = cheapest_parity_changes(links, parts, odd);
      CHECK(flipped(links, parts, changes) == odd);
      CHECK(std::is_sorted(changes.begin(), changes.end()));
    }
  }
}
