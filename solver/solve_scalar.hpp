#pragma once

#include <vector>

#include "mesher/mesh/mesh.hpp"
#include "solver/scalar_problem.hpp"

namespace anisofront {

/// P1 solution, one value per vertex.
/// Throws InputError (see assemble() and dirichlet_constraints(), and a problem without reaction
/// and without Dirichlet conditions, whose solution is free up to a constant) and MeshingError (see
/// solve_positive_definite()).
std::vector<double> solve_scalar(const Mesh& mesh, const ScalarProblem& problem);

}  // namespace anisofront
