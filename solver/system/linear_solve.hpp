#pragma once

#include <string>

#include "mesher/geometry/monitor.hpp"
#include "solver/system/assemble.hpp"

namespace anisofront {

enum class LinearMethod {
  /// simplicial for small systems; above, supernodal, or for scalar systems multigrid with
  /// supernodal as the way out when it converges slowly (and the reverse when memory is short)
  automatic,
  simplicial,  ///< Eigen LDL', AMD ordering
  supernodal,  ///< CHOLMOD with BLAS; simplicial where the build leaves it out
  multigrid,   ///< conjugate gradients, smoothed aggregation: scalar problems only
  general      ///< sparse LU: the only one for matrices that are not symmetric
};

struct LinearOptions {
  LinearMethod method = LinearMethod::automatic;
  bool symmetric = true;
  /// The unknowns are one scalar per point (multigrid may be chosen).
  bool scalar = false;
  /// Largest memory of the factors in bytes; 0: 80 % of what the machine has free.
  double memory_limit = 0;
  int max_refinements = 4;
};

/// What was done and how good it is.
struct LinearReport {
  std::string method;  ///< "simplicial LDL'", "supernodal Cholesky (CHOLMOD)", ...
  Index unknowns = 0;
  double nonzeros = 0;         ///< of the matrix
  double factor_nonzeros = 0;  ///< of L (0: no factor)
  /// Lower estimate for the scaled matrix, near the truth for smooth loads (0: not known).
  double condition = 0;
  /// |b - A x| / |b| of the symmetrically scaled system, of the solution before it is rounded to
  /// double (a rounded one has residuals of round-off times the condition).
  double residual = 0;
  int refinements = 0;
  int iterations = 0;  ///< of the conjugate gradients
  double factor_seconds = 0, solve_seconds = 0;
};

struct LinearResult {
  Eigen::VectorXd solution;
  LinearReport report;
};

/// Scales symmetrically by the diagonal, factorises, solves and refines, with residuals in twice
/// the working precision, until the relative error is about 1e-11 and the residual 1e-12, or until
/// the residual stops falling. Warns when it stays above 1e-8. Results do not depend on the number
/// of threads. Iterative methods start from the `guess` (null: from 0) and stop at the same
/// residual relative to b, direct ones ignore it. Throws MeshingError that names the unknown where
/// the matrix is not positive definite or a result is not finite, InputError for a guess of another
/// size or with values that are not finite, and BudgetError with the estimate before factors are
/// computed that would not fit into the memory limit. Precondition: symmetric systems are symmetric
/// to round-off.
LinearResult solve_linear(const LinearSystem& system, const LinearOptions& options = {},
                          const Monitor& monitor = {}, const Eigen::VectorXd* guess = nullptr);

}  // namespace anisofront
