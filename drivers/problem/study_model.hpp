#pragma once

#include "adapt/model.hpp"
#include "drivers/study/study.hpp"

namespace anisofront {

/// The problem of a study as the loop solves it: its [solver] settings, goal, points and lines of
/// [output]. Messages of the solver about the input start with the line of the problem.
/// Throws as scalar_problem(), plate_problem() and watched_lines() do. Precondition: the study has
/// a problem.
Model study_model(const Study& study, const Domain& domain, const Monitor& monitor = {});

/// The problem alone, for reference solutions, on triangles: mitc4, which is for quadrilaterals
/// only, gives way to mitc there.
Model reference_model(const Study& study, const Domain& domain);

}  // namespace anisofront
