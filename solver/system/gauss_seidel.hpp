#pragma once

#include "solver/system/sparse_rows.hpp"

namespace anisofront {

/// Gauss-Seidel within blocks of rows of fixed number, which run in parallel, Jacobi between them
/// with |a_ij| of other blocks added to the diagonal: convergent for all positive definite
/// matrices. Reference: A. Baker, R. Falgout, T. Kolev, U. Yang, Multigrid smoothers for
/// ultraparallel computing, SIAM J. Sci. Comput. 33 (2011) 2864-2887, section 5.
class GaussSeidel {
 public:
  /// `matrix` must outlive it.
  explicit GaussSeidel(const SparseRows& matrix);

  /// One forward sweep for A x = b from x = 0.
  void forward_from_zero(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;
  /// One backward sweep, the adjoint of the forward one. `work` holds x at entry.
  void backward(const Eigen::VectorXd& b, Eigen::VectorXd& x, Eigen::VectorXd& work) const;

 private:
  Index block_begin(Index block) const;

  const SparseRows& matrix_;
  Index blocks_;
  Eigen::VectorXd inverse_diagonal_;
};

}  // namespace anisofront
