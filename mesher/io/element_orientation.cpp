#include "mesher/io/element_orientation.hpp"

#include <utility>

#include "mesher/geometry/predicates.hpp"

namespace anisofront {

const char* make_anticlockwise(Triangle& triangle, std::span<const Point> points) {
  auto& [a, b, c] = triangle;
  const int sign = orientation(points[a], points[b], points[c]);
  if (sign == 0) return "has no area: its vertices lie on a line";
  if (sign < 0) std::swap(b, c);
  return nullptr;
}

const char* make_anticlockwise(Quad& quad, std::span<const Point> points) {
  int left = 0;
  int right = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const int sign =
        orientation(points[quad[k]], points[quad[(k + 1) % 4]], points[quad[(k + 2) % 4]]);
    left += sign > 0;
    right += sign < 0;
  }
  if (left == 0 && right == 0) return "has no area: its vertices lie on a line";
  if (left == right) return "crosses itself: its vertices must be given in cyclic order";
  if (right > left) std::swap(quad[1], quad[3]);
  return nullptr;
}

}  // namespace anisofront
