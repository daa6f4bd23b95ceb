#pragma once

#include <optional>

#include "adapt/analyse.hpp"
#include "drivers/study/study.hpp"
#include "mesher/background/alternating_digital_tree.hpp"

namespace anisofront {

/// A box round the control points of all curves, which a NURBS curve does not leave.
Box control_box(const Domain& domain);

/// Limits that the study gives; the preset paper limits no gradation.
MetricLimits prescribed_limits(const Study& study);

/// The same for errors of a problem, with defaults: gradation 3, hmin of plates t/100, their
/// stretch by plate_stretch_limit() with the longer side of the plate (twice that of the domain
/// when it ends at a line of symmetry).
MetricLimits problem_limits(const Study& study, const Domain& domain);

/// Layers that the study names. Those of plates, unless it says otherwise, lie along soft supports
/// and free edges and are t/sqrt(12 k) wide. Where the thickness varies, the smallest counts.
/// Throws UsageError for curves that the domain does not have, and for a scalar problem whose layer
/// lacks curves or width.
LayerSettings layer_settings(const Study& study, const Domain& domain);

/// Throws UsageError for a region or curve that the domain does not have.
std::optional<Goal> study_goal(const Study& study, const Domain& domain);

/// The [adapt] table with all names resolved.
AdaptSettings adapt_settings(const Study& study, const Domain& domain);

}  // namespace anisofront
