#pragma once

#include <vector>

#include "mesher/geometry/domain.hpp"
#include "mesher/geometry/monitor.hpp"

namespace anisofront {

/// Regions on the two sides of a curve (the domain speaks of loops); no region is outside.
struct CurveSides {
  Index left = kNoIndex, right = kNoIndex;
  bool used() const { return left != kNoIndex || right != kNoIndex; }
};

/// A part of a curve between two vertices that must be kept.
struct CurvePiece {
  Index curve;
  double t0, t1;
  Index start, end;
};

/// The vertices that any discretisation of the domain must have, and the pieces of curves between.
struct CurveFrame {
  std::vector<Point> vertices;
  std::vector<CurveSides> sides;      ///< per curve
  std::vector<CurvePiece> pieces;     ///< of the curves that bound a region or are embedded in one
  std::vector<Index> point_vertices;  ///< per domain point: its vertex, kNoIndex when on no curve
};

/// Curve ends within `tolerance` of each other become one vertex; domain points, and ends of
/// embedded curves, within a thousand tolerances of a curve split it, and so do points where it
/// turns by more than `corner_angle` degrees. Warns about curves without a region.
CurveFrame make_curve_frame(const Domain& domain, double tolerance, double corner_angle,
                            const Monitor& monitor);

}  // namespace anisofront
