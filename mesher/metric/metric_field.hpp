#pragma once

#include <functional>
#include <vector>

#include "mesher/metric/metric.hpp"

namespace anisofront {

/// How metrics are interpolated between vertices. All three give a positive definite result.
enum class Interpolation {
  linear_size,             ///< linear in M^(-1/2): cheapest, independent of vertex order; default
  simultaneous_reduction,  ///< the paper, Eqns 4-7
  log_euclidean,           ///< exp of the linear interpolant of log M
};

/// One metric per vertex of a (background) mesh.
using MetricField = std::vector<Metric>;

/// A metric known everywhere: an exact formula or a look-up in a background mesh. For reports and
/// sampling; the hot paths of the mesher use BackgroundMesh directly.
using MetricFunction = std::function<Metric(Point)>;

}  // namespace anisofront
