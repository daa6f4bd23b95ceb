#pragma once

#include "solver/assemble.hpp"

namespace anisofront {

/// Solution of a symmetric positive definite system by sparse LDL' (Eigen, AMD ordering).
/// Throws MeshingError that names the mechanism when the factorisation fails, a pivot is not
/// positive (with the unknown) or the result is not finite.
Eigen::VectorXd solve_positive_definite(const LinearSystem& system);

}  // namespace anisofront
