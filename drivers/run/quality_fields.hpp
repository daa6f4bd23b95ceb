#pragma once

#include "mesher/io/gmsh.hpp"
#include "mesher/metric/metric_field.hpp"

namespace anisofront {

/// Adds to the element data of a file "quality" (alpha~ of triangles and beta~ of quadrilaterals in
/// the metric given at the vertices) and "scaled_jacobian" (of quadrilaterals, in the plane).
/// `step`: the cycle they belong to. Without a metric there is no quality.
void add_quality_fields(MeshFile& file, const MetricField& metric, int step = 0);

}  // namespace anisofront
