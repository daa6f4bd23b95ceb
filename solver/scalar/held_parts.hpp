#pragma once

#include <span>

#include "solver/scalar/scalar_problem.hpp"
#include "solver/system/constraints.hpp"

namespace anisofront {

/// Throws InputError, naming region and place, for the first part of the mesh (elements connected
/// through vertices) that has neither a prescribed unknown nor a reaction nor a transfer: there u
/// is free up to a constant.
void require_held_parts(const FeMesh& mesh, const ScalarProblem& problem,
                        std::span<const Constraint> constraints);

}  // namespace anisofront
