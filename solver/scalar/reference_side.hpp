#pragma once

#include "solver/space/element_map.hpp"

namespace anisofront {

/// Side k of a reference element, from corner k to corner k + 1.
struct ReferenceSide {
  Vector start, direction;

  ReferenceSide(Shape shape, int k) {
    constexpr Vector kTriangle[] = {{0, 0}, {1, 0}, {0, 1}};
    constexpr Vector kSquare[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const bool is_triangle = shape == Shape::triangle;
    start = is_triangle ? kTriangle[k] : kSquare[k];
    direction = (is_triangle ? kTriangle[(k + 1) % 3] : kSquare[(k + 1) % 4]) - start;
  }
  /// s in [0, 1].
  ReferencePoint at(double s) const {
    return {start.x + s * direction.x, start.y + s * direction.y};
  }
};

}  // namespace anisofront
