#pragma once

#include "solver/system/assemble.hpp"

namespace anisofront {

/// A vector in about twice the working precision: high + low, |low| at most half an ulp of high.
struct ExtendedVector {
  Eigen::VectorXd high, low;

  explicit ExtendedVector(Eigen::Index size)
      : high(Eigen::VectorXd::Zero(size)), low(Eigen::VectorXd::Zero(size)) {}
  void add(const Eigen::VectorXd& step);
};

/// b - A x, computed as if in twice the working precision and rounded once. `rows` holds A by rows,
/// that is, the transpose of A (A itself if that is symmetric).
/// Reference: T. Ogita, S. Rump, S. Oishi, Accurate sum and dot product, SIAM J. Sci. Comput. 26
/// (2005) 1955-1988, algorithm Dot2.
Eigen::VectorXd extended_residual(const SparseMatrix& rows, const Eigen::VectorXd& b,
                                  const ExtendedVector& x);

}  // namespace anisofront
