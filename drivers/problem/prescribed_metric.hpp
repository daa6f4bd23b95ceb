#pragma once

#include "drivers/study/study.hpp"
#include "mesher/metric/metric_field.hpp"

namespace anisofront {

/// The metric of a study as a function. Cheap to call (everything is compiled once); not for use by
/// several threads at once. A direction e1 = (0, 0) counts as (1, 0).
/// Throws UsageError for mistakes in the expressions and unknown curves in distance_to; the
/// function throws InputError with the coordinates where a size is not positive and finite.
MetricFunction prescribed_metric(const PrescribedMetric& metric, const Domain& domain,
                                 const MetricLimits& limits);

}  // namespace anisofront
