#include "mesher/background/alternating_digital_tree.hpp"

#include <algorithm>
#include <random>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

std::vector<Index> query(const AlternatingDigitalTree& tree, const Box& box) {
  std::vector<Index> found;
  tree.query(box, [&](Index item) { found.push_back(item); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Index> brute_force(const std::vector<Box>& boxes, const Box& box) {
  std::vector<Index> found;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& b = boxes[i];
    const bool apart = b.high.x < box.low.x || b.low.x > box.high.x || b.high.y < box.low.y ||
                       b.low.y > box.high.y;
    if (!apart) found.push_back(static_cast<Index>(i));
  }
  return found;
}

/// Boxes with corners on a coarse lattice, so that many touch, coincide or have no extent.
Box lattice_box(std::mt19937_64& random, int most) {
  std::uniform_int_distribution<int> corner(0, 16), extent(0, most);
  const double x = corner(random) / 16., y = corner(random) / 16.;
  return {{x, y}, {std::min(1., x + extent(random) / 16.), std::min(1., y + extent(random) / 16.)}};
}

Box random_box(std::mt19937_64& random, double most) {
  std::uniform_real_distribution<double> corner(0, 1 - most), extent(0, most);
  const double x = corner(random), y = corner(random);
  return {{x, y}, {x + extent(random), y + extent(random)}};
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("boxes that touch overlap") {
    const Box box{{0, 0}, {1, 1}};
    CHECK(overlap(box, {{1, 1}, {2, 2}}));
    CHECK(overlap(box, {{1, 0.5}, {1, 0.5}}));
    CHECK_FALSE(overlap(box, {{1.0000001, 0}, {2, 1}}));
    CHECK_FALSE(overlap(box, {{0, -2}, {1, -1e-300}}));
  }

  TEST_CASE("an empty tree finds nothing") {
    const AlternatingDigitalTree tree({{0, 0}, {1, 1}});
    CHECK(query(tree, {{-9, -9}, {9, 9}}).empty());
  }

  TEST_CASE("items are numbered in the order of insertion") {
    AlternatingDigitalTree tree({{0, 0}, {4, 1}});
    for (int i = 0; i < 4; ++i) tree.insert({{1. * i, 0}, {i + 0.5, 1}});
    CHECK(query(tree, {{2.2, 0.5}, {2.2, 0.5}}) == std::vector<Index>{2});
    CHECK(query(tree, {{0.5, 0}, {1, 0}}) == std::vector<Index>{0, 1});
    CHECK(query(tree, {{2.6, 0}, {2.9, 1}}).empty());
  }

  TEST_CASE("queries agree with brute force on random boxes") {
    std::mt19937_64 random(1);
    for (const double size : {0.001, 0.05, 0.5}) {
      AlternatingDigitalTree tree({{0, 0}, {1, 1}});
      std::vector<Box> boxes;
      for (int i = 0; i < 500; ++i) {
        boxes.push_back(random_box(random, size));
        tree.insert(boxes.back());
        const Box box = random_box(random, 0.1);
        CHECK(query(tree, box) == brute_force(boxes, box));
      }
    }
  }

  TEST_CASE("queries agree with brute force on touching and degenerate and equal boxes") {
    std::mt19937_64 random(2);
    AlternatingDigitalTree tree({{0, 0}, {1, 1}});
    std::vector<Box> boxes;
    for (int i = 0; i < 400; ++i) {
      boxes.push_back(lattice_box(random, i % 3 == 0 ? 0 : 4));
      tree.insert(boxes.back());
    }
    for (int i = 0; i < 1000; ++i) {
      const Box box = lattice_box(random, i % 2 == 0 ? 0 : 3);
      CHECK(query(tree, box) == brute_force(boxes, box));
    }
  }

  TEST_CASE("many copies of one box are all found") {
    AlternatingDigitalTree tree({{0, 0}, {1, 1}});
    for (int i = 0; i < 200; ++i) tree.insert({{0.3, 0.3}, {0.3, 0.3}});
    CHECK(query(tree, {{0.3, 0.3}, {0.3, 0.3}}).size() == 200);
    CHECK(query(tree, {{0.4, 0.3}, {0.5, 0.3}}).empty());
  }
}
