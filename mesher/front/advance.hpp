#pragma once

#include <cstdint>

#include "mesher/background/background_mesh.hpp"
#include "mesher/front/front_queue.hpp"
#include "mesher/front/work_mesh.hpp"
#include "mesher/geometry/monitor.hpp"

namespace anisofront {

/// How the apex of a new element is judged and placed.
enum class ElementFormation {
  fast,         ///< Newton-corrected ideal point, mean metrics, log-mean lengths
  paper,        ///< best of C1, C2, C3 (Eqn 23, App. C), alpha~ and Appendix B lengths
  right_angle,  ///< right isosceles triangles, two of which form a square
};

struct FrontOptions {
  BaseOrder order = BaseOrder::metric_length;
  /// From this many expected triangles on, metric_length becomes metric_class.
  double class_order_from = 6e4;
  ElementFormation formation = ElementFormation::fast;
  /// No new vertex nearer than this to the front, in metric length (the paper: 0.1).
  double closeness = 0.55;
  /// Radius of the search ellipse in metric length (the paper: 0.75).
  double search_radius = 0.75;
  /// Most Newton steps on l(AC) = l(BC) = 1 for the ideal point (fast), or on the unit leg
  /// (right_angle).
  int newton_steps = 2;
  /// Length of DC below which the contracted ideal point is given up (step vi).
  double least_offset = 0.1;
};

/// The paper to the letter: shortest physical base, closeness 0.1.
FrontOptions paper_front_options();

/// Right isosceles triangles in layers from the boundary on, as a start for quadrilaterals: bases
/// by age, apices at 90 degrees above an end of legs, at 45 degrees over hypotenuses. Twice the
/// complexity of the background is the number of triangles to be expected.
FrontOptions right_angle_front_options();

struct FrontStatistics {
  std::int64_t steps = 0;  ///< elements formed
  std::int64_t new_vertices = 0;
  std::int64_t contractions = 0;  ///< of the ideal point (Eqn 24)
  std::int64_t fallbacks = 0;     ///< elements formed by step (vi)
};

/// Fills everything left of the segments with triangles (section 3, "Metric Triangulation", steps
/// (i)-(vii)). On entry `mesh` holds the boundary vertices and the segments, no triangles.
/// `expected_triangles` only tunes the search structure and progress.
/// Throws Interrupted; MeshingError when the segments cross, so that no vertex is visible.
FrontStatistics advance_front(const BackgroundMesh& background, WorkMesh& mesh,
                              const FrontOptions& options, double expected_triangles,
                              const Monitor& monitor = {});

}  // namespace anisofront
