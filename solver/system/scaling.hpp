#pragma once

#include "solver/system/assemble.hpp"

namespace anisofront {

/// Factors s_i = 2^k such that s_i^2 |a_ii| lies in [1/2, 2]: S A S has diagonal 1 up to 2 and,
/// as powers of two multiply exactly, no rounding. Where a_ii is 0, s_i is 1.
/// Throws MeshingError for diagonals that are not finite.
Eigen::VectorXd symmetric_scaling(const SparseMatrix& matrix);

/// The largest column sum of |S A S|.
double scaled_norm(const SparseMatrix& matrix, const Eigen::VectorXd& scale);

}  // namespace anisofront
