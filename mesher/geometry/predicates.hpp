#pragma once

#include <cmath>

#include "mesher/geometry/point.hpp"

namespace anisofront {

namespace detail {
/// The slow, exact path of orientation(); called when rounding could hide the sign.
int exact_orientation(Point a, Point b, Point c);
}  // namespace detail

/// Exact sign of the signed area of the triangle abc: 1 anticlockwise, -1 clockwise, 0 collinear.
/// Laws: orientation(a,b,c) == orientation(b,c,a) == -orientation(b,a,c), for all finite input
/// whose products neither overflow nor underflow.
/// Reference: J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast robust
/// geometric predicates, Discrete Comput. Geom. 18 (1997), doi:10.1007/PL00009321 (filter A).
inline int orientation(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  constexpr double kFilter = 3.3306690738754716e-16;  // (3 + 16 eps) eps, eps = 2^-53
  const double bound = kFilter * (std::fabs(left) + std::fabs(right));
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return detail::exact_orientation(a, b, c);
}

}  // namespace anisofront
