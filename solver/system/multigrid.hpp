#pragma once

#include <memory>

#include "solver/system/factors.hpp"
#include "solver/system/sparse_rows.hpp"

namespace anisofront {

/// The smoothed aggregation hierarchy of a symmetric positive definite matrix whose solutions are
/// nearly constant where they are hardest to find (scalar problems of second order).
/// Reference: P. Vanek, J. Mandel, M. Brezina, Algebraic multigrid by smoothed aggregation for
/// second and fourth order elliptic problems, Computing 56 (1996) 179-196.
class Multigrid {
 public:
  explicit Multigrid(const SparseMatrix& matrix);
  ~Multigrid();

  /// One V cycle with one sweep before and one after: a symmetric positive definite approximation
  /// of A^-1 b.
  void cycle(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;
  const SparseRows& finest() const;  ///< the matrix by rows
  int levels() const;
  /// Nonzeros of the matrices and prolongations of all levels.
  double nonzeros() const;

 private:
  struct Hierarchy;
  std::unique_ptr<Hierarchy> hierarchy_;
};

/// Conjugate gradients with a V cycle: what solves with S A S and adds its steps to `steps`.
/// `scale` and `steps` must outlive it. Throws MeshingError for matrices that are not positive
/// definite or when `max_steps` steps do not converge.
Factors multigrid_solver(const SparseMatrix& matrix, const Eigen::VectorXd& scale, int max_steps,
                         int& steps);

}  // namespace anisofront
