#pragma once

#include "mesher/metric/statistics.hpp"

namespace anisofront {

/// What `anisofront check` says of quadrilaterals, for meshes that it calls invalid too: other
/// meshers leave concave ones, which would make the geometric mean 0.
struct QuadQuality {
  MeshStatistics all;    ///< of quadrilaterals and triangles together
  double beta_mean = 0;  ///< geometric mean over the convex quadrilaterals
  double beta_min = 1;   ///< over all of them; -1 when one is concave
  Index bad = 0;         ///< concave, or beta~ below 0.2
};

QuadQuality quad_quality(const Mesh& mesh, const MetricFunction& metric);

}  // namespace anisofront
