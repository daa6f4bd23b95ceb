#pragma once

#include "solver/system/assemble.hpp"

namespace anisofront {

/// Nonzeros of the Cholesky factor L, diagonal included, of a symmetric matrix whose upper triangle
/// (at least) is stored. O(result) by the elimination tree: J. Liu, The role of elimination trees
/// in sparse factorization, SIAM J. Matrix Anal. Appl. 11 (1990) 134-172.
double factor_nonzeros(const SparseMatrix& matrix);

/// Runs of unknowns whose columns have the same pattern (the components of one node), as a graph.
/// An ordering of the runs orders the matrix, in a fraction of the time.
struct CompressedPattern {
  std::vector<Index> first_unknown;      ///< of each run; at the end the number of unknowns
  std::vector<std::int64_t> begin;       ///< neighbours of run r: begin[r] .. begin[r + 1] - 1
  std::vector<std::int64_t> neighbours;  ///< ascending, the run itself included

  std::size_t runs() const { return begin.size() - 1; }
};

/// Precondition: a symmetric pattern, both triangles stored.
CompressedPattern compressed_pattern(const SparseMatrix& matrix);

/// The unknowns in the order of their runs.
std::vector<std::int64_t> unknown_order(const CompressedPattern& pattern,
                                        const std::vector<std::int64_t>& run_order);

}  // namespace anisofront
