#pragma once

#include "solver/scalar/scalar_problem.hpp"
#include "solver/system/assemble.hpp"

namespace anisofront {

/// Matrix and load of the problem for order 1 or 2 with its flux conditions, nothing imposed yet;
/// `dofs`: of scalar_layout(). Throws InputError as scalar_kernel() and add_fluxes() do.
LinearSystem scalar_system(const FeMesh& mesh, const ScalarProblem& problem, const DofMap& dofs,
                           int order, int threads = 0);

}  // namespace anisofront
