#include "mesher/geometry/convex_polygon.hpp"

namespace anisofront {

std::vector<Point> left_part(const std::vector<Point>& polygon, Point p, Point q) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double at_a = twice_area(p, q, a), at_b = twice_area(p, q, b);
    if (at_a >= 0) kept.push_back(a);
    // A corner on the line is kept above; only a true crossing adds a new one.
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0))
      kept.push_back(lerp(a, b, at_a / (at_a - at_b)));
  }
  return kept;
}

}  // namespace anisofront
