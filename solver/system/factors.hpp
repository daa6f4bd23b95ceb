#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "solver/system/assemble.hpp"
#include "solver/system/memory.hpp"

namespace anisofront {

/// A factorised matrix S A S, S = diag(scale).
struct Factors {
  std::string method;   ///< for LinearReport
  double nonzeros = 0;  ///< of L (and U)
  /// Overwrites r by (S A S)^-1 r. Iterative methods stop when the residual has fallen to the share
  /// `reduction` of r, direct ones go as far as they can.
  std::function<void(Eigen::VectorXd& r, double reduction)> solve;
};

/// Eigen's LDL' with AMD ordering. Precondition here and for the next: A is symmetric. Both throw
/// MeshingError that names the unknown whose pivot is not positive, and BudgetError before factors
/// are computed that would exceed the limit.
Factors simplicial_factors(const SparseMatrix& matrix, const Eigen::VectorXd& scale,
                           const MemoryLimit& limit);

/// CHOLMOD's supernodal LL' with BLAS on one thread (its result would depend on their number);
/// the same as simplicial_factors() where the build leaves CHOLMOD out. Reference: Y. Chen, T.
/// Davis, W. Hager, S. Rajamanickam, Algorithm 887: CHOLMOD, ACM Trans. Math. Softw. 35 (2008) 22.
Factors supernodal_factors(const SparseMatrix& matrix, const Eigen::VectorXd& scale,
                           const MemoryLimit& limit);

/// LU of any matrix, of UMFPACK or, where the build leaves that out, of Eigen. Throws MeshingError
/// for singular matrices and (UMFPACK only) BudgetError. Reference: T. Davis, Algorithm 832:
/// UMFPACK V4.3, ACM Trans. Math. Softw. 30 (2004) 196-199.
Factors general_factors(const SparseMatrix& matrix, const Eigen::VectorXd& scale,
                        const MemoryLimit& limit);

/// Pivots below this share of the largest, of a matrix scaled to unit diagonal, are rounding: the
/// matrix is singular. (Plates of thickness 1e-5 have shares down to 1e-9.)
inline constexpr double kPivotTolerance = 1e-14;

/// Throws MeshingError that the matrix is not positive definite, from this pivot at `unknown`.
[[noreturn]] void refuse_pivot(double pivot, std::int64_t unknown);

/// Throws MeshingError that the matrix is singular.
[[noreturn]] void refuse_singular_pivot(double pivot, std::int64_t unknown);

}  // namespace anisofront
