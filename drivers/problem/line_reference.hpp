#pragma once

#include <optional>

#include "adapt/point_state.hpp"
#include "adapt/profile.hpp"
#include "drivers/problem/line_points.hpp"
#include "drivers/study/study.hpp"

namespace anisofront {

/// The quantities of the problem of a study. Precondition: it has one.
Quantities study_quantities(const Study& study);

/// What a line is compared with, columns s and quantities: the table or the expressions that the
/// study gives, else all quantities of the exact solution where it is known, at the points of the
/// line. Throws UsageError with the line of the study for unknown quantities, mistakes in
/// expressions and files that are missing or no such table, and InputError for values that are not
/// finite. Precondition: the study has a problem.
std::optional<NumberTable> line_reference(const Study& study, const LineRequest& request,
                                          const LinePoints& line);

}  // namespace anisofront
