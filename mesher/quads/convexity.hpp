#pragma once

#include <array>

#include "mesher/geometry/predicates.hpp"
#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// Whether the corner a b c turns left by a sine above 1e-8: exact points of a straight line, once
/// rounded, turn left by some 1e-17 half of the time, and such a corner is of no use.
inline bool is_convex_corner(Point a, Point b, Point c) {
  constexpr double kLeastSine2 = 1e-16;
  const Vector u = b - a, v = c - b;
  const double turn = cross(u, v);
  return turn > 0 && turn * turn > kLeastSine2 * squared_norm(u) * squared_norm(v);
}

/// Strictly convex by the exact predicate, without flat corners; anticlockwise.
inline bool is_convex_quad(const std::array<Point, 4>& p) {
  for (int k = 0; k < 4; ++k) {
    const Point a = p[k], b = p[(k + 1) & 3], c = p[(k + 2) & 3];
    if (!is_convex_corner(a, b, c) || orientation(a, b, c) <= 0) return false;
  }
  return true;
}

}  // namespace anisofront
