#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// Disjoint sets of the numbers 0 .. n - 1, each named by its smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(Index a, Index b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace anisofront
