#pragma once

#include <cstdint>
#include <vector>

#include "mesher/background/background_mesh.hpp"
#include "mesher/front/work_mesh.hpp"
#include "mesher/geometry/domain.hpp"
#include "mesher/geometry/monitor.hpp"

namespace anisofront {

struct BoundaryOptions {
  /// true: length over the old boundary segments (Eqns 18-20 to the letter); false: the curve
  /// itself is sampled and its chords, which become the edges, are made equally long in the metric.
  bool over_old_segments = false;
  /// Longest sample step, in metric length, on curves.
  double sample_length = 0.25;
  /// Largest distance of an edge from its curve, length unit of the model; <= 0: no limit.
  double chord_height = 0;
  /// Inside curves, points where they turn by more degrees are vertices of every mesh.
  double corner_angle = 20;
  /// Every part of the domain bounded by segments gets an even number of edges (those of embedded
  /// curves count twice, interfaces once on each side), so that quadrilaterals can fill it. Numbers
  /// of edges differ from Eqn 19 by one at most, where that costs least in |ln(N / L)|; closed
  /// curves get at least 4 edges and embedded curves that touch no other at least 2.
  bool even = false;
};

struct Boundary {
  WorkMesh mesh;  ///< vertices and segments, no triangles
  std::vector<Index>
      point_vertices;  ///< per domain point: its vertex, or kNoIndex (inside a region)
};

/// Cuts the curves of the domain into unit edges (section 3, "Boundary segments generation").
/// Edges that cross or touch others are halved until none does; curves that cross whatever the
/// refinement are refused with InputError, naming the curves and the place. `max_segments` bounds
/// their number (BudgetError). Warns about curves nearer to each other than the metric can see.
Boundary discretise_boundary(const Domain& domain, const Mesh& old_mesh,
                             const BackgroundMesh& background, const BoundaryOptions& options,
                             std::int64_t max_segments, const Monitor& monitor = {});

}  // namespace anisofront
