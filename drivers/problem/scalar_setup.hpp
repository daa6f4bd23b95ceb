#pragma once

#include <optional>

#include "drivers/study/study_problem.hpp"
#include "mesher/geometry/domain.hpp"
#include "solver/scalar/exact_solutions.hpp"

namespace anisofront {

/// The known solution that a study names, if any.
std::optional<ExactSolution> known_solution(const ScalarProblemText& text);

/// Names become tags, expressions functions; the source is that of `exact` unless the study has one
/// of its own. Throws UsageError for names that the domain does not have.
ScalarProblem scalar_problem(const ScalarProblemText& text, const Domain& domain,
                             const std::optional<ExactSolution>& exact);

}  // namespace anisofront
