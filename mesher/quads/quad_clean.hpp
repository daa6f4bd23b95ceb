#pragma once

#include <cstdint>

#include "mesher/geometry/monitor.hpp"
#include "mesher/quads/quad_work.hpp"

namespace anisofront {

/// How hard the clean-up tries.
struct CleanOptions {
  /// Quadrilaterals with an energy above this are worked on (energies without the potential).
  double threshold = 0.6;
  int most_passes = 12;
  int first_sweeps = 4;  ///< smoothing before the first pass
  int last_sweeps = 6;   ///< and after the last
};

struct CleanStatistics {
  std::int64_t trials = 0, operations = 0;
};

/// Smooths and repairs the topology: around every bad quadrilateral, worst first, the local
/// operations are tried; each is judged after its surroundings have been smoothed, and kept if the
/// energy has gone down. The number of quadrilaterals that are not convex never grows.
CleanStatistics clean(QuadWork& work, const CleanOptions& options, const Monitor& monitor = {});

/// A last round only around quadrilaterals with beta~ below 0.4 or an edge outside [0.7, 1.42],
/// with lengths by Simpson's rule. The weights of `work` are changed.
CleanStatistics polish(QuadWork& work);

}  // namespace anisofront
