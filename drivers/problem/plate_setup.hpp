#pragma once

#include "drivers/study/study_plate.hpp"
#include "mesher/geometry/domain.hpp"
#include "mesher/geometry/monitor.hpp"

namespace anisofront {

/// Names become tags, expressions functions. Warns of boundary curves that no condition mentions
/// (they are free). Throws UsageError for names that the domain does not have.
PlateProblem plate_problem(const PlateProblemText& text, const Domain& domain,
                           const Monitor& monitor = {});

}  // namespace anisofront
