#pragma once

#include "mesher/geometry/curve.hpp"

namespace anisofront {

/// Point of the curve between its points a and b. Rounding must not take it off a line that runs
/// along an axis.
inline Point point_between(const NurbsCurve& curve, double t, Point a, Point b) {
  const Point p = evaluate(curve, t);
  if (curve.degree > 1) return p;
  return {a.x == b.x ? a.x : p.x, a.y == b.y ? a.y : p.y};
}

}  // namespace anisofront
