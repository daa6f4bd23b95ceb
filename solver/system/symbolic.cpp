#include "solver/system/symbolic.hpp"

#include <algorithm>

namespace anisofront {
namespace {

bool same_pattern(const SparseMatrix& matrix, Index a, Index b) {
  const Index* outer = matrix.outerIndexPtr();
  const Index* rows = matrix.innerIndexPtr();
  return std::equal(rows + outer[a], rows + outer[a + 1], rows + outer[b], rows + outer[b + 1]);
}

/// Runs of columns with one pattern; fills the run of each unknown.
std::vector<Index> runs_of(const SparseMatrix& matrix, std::vector<Index>& run) {
  std::vector<Index> first;
  for (Index u = 0; u < matrix.cols(); ++u) {
    if (u == 0 || !same_pattern(matrix, u - 1, u)) first.push_back(u);
    run[u] = static_cast<Index>(first.size()) - 1;
  }
  first.push_back(static_cast<Index>(matrix.cols()));
  return first;
}

}  // namespace

double factor_nonzeros(const SparseMatrix& matrix) {
  std::vector<Index> parent(matrix.cols(), kNoIndex);
  std::vector<Index> visited(matrix.cols(), kNoIndex);
  auto nonzeros = static_cast<double>(matrix.cols());
  for (Index column = 0; column < matrix.cols(); ++column) {
    visited[column] = column;
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
      for (auto k = static_cast<Index>(entry.row()); k < column && visited[k] != column;
           k = parent[k]) {
        if (parent[k] == kNoIndex) parent[k] = column;
        visited[k] = column;
        ++nonzeros;  // L(column, k)
      }
  }
  return nonzeros;
}

CompressedPattern compressed_pattern(const SparseMatrix& matrix) {
  std::vector<Index> run(matrix.cols());
  CompressedPattern pattern{runs_of(matrix, run), {0}, {}};
  for (std::size_t r = 0; r + 1 < pattern.first_unknown.size(); ++r) {
    for (SparseMatrix::InnerIterator entry(matrix, pattern.first_unknown[r]); entry; ++entry) {
      const Index neighbour = run[entry.row()];
      const bool is_new = pattern.neighbours.size() == static_cast<std::size_t>(pattern.begin[r]) ||
                          pattern.neighbours.back() != neighbour;
      if (is_new) pattern.neighbours.push_back(neighbour);
    }
    pattern.begin.push_back(static_cast<std::int64_t>(pattern.neighbours.size()));
  }
  return pattern;
}

std::vector<std::int64_t> unknown_order(const CompressedPattern& pattern,
                                        const std::vector<std::int64_t>& run_order) {
  std::vector<std::int64_t> order;
  order.reserve(pattern.first_unknown.back());
  for (const std::int64_t r : run_order)
    for (Index u = pattern.first_unknown[r]; u < pattern.first_unknown[r + 1]; ++u)
      order.push_back(u);
  return order;
}

}  // namespace anisofront
