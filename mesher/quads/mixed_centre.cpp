#include "mesher/quads/mixed_centre.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "mesher/geometry/convex_polygon.hpp"
#include "mesher/geometry/predicates.hpp"
#include "mesher/quads/convexity.hpp"

namespace anisofront {
namespace {

using Points = std::span<const Point>;

/// The centre must lie strictly left of these lines.
template <class Visit>
bool all_lines(Points corners, Points midpoints, Visit&& visit) {
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Point before = midpoints[k == 0 ? n - 1 : k - 1], corner = corners[k];
    const Point after = midpoints[k], next = corners[k + 1 == n ? 0 : k + 1];
    if (!visit(corner, after) || !visit(after, next) || !visit(before, after)) return false;
  }
  return true;
}

bool corners_are_convex(Points corners, Points midpoints) {
  for (std::size_t k = 0; k < corners.size(); ++k)
    if (!is_convex_corner(midpoints[k == 0 ? corners.size() - 1 : k - 1], corners[k], midpoints[k]))
      return false;
  return true;
}

bool is_centre(Points corners, Points midpoints, Point centre) {
  return all_lines(corners, midpoints,
                   [&](Point p, Point q) { return orientation(p, q, centre) > 0; });
}

std::vector<Point> box_around(Points corners, Points midpoints) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Point low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};
  for (const Points points : {corners, midpoints})
    for (const Point p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

/// Centre of gravity of a convex polygon.
Point centroid_of(const std::vector<Point>& polygon) {
  Vector sum{0, 0};
  double area = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vector u = polygon[i] - polygon[0], v = polygon[i + 1] - polygon[0];
    sum = sum + cross(u, v) * (u + v);
    area += cross(u, v);
  }
  return area > 0 ? polygon[0] + (1 / (3 * area)) * sum : polygon[0];
}

}  // namespace

Point mean_of(std::span<const Point> midpoints) {
  Point sum{0, 0};
  for (const Point m : midpoints) sum = sum + m;
  return (1. / static_cast<double>(midpoints.size())) * sum;
}

std::optional<Point> centre_of_division(Points corners, Points midpoints) {
  if (!corners_are_convex(corners, midpoints)) return {};
  const Point mean = mean_of(midpoints);
  if (is_centre(corners, midpoints, mean)) return mean;
  std::vector<Point> possible = box_around(corners, midpoints);
  all_lines(corners, midpoints, [&](Point p, Point q) {
    possible = left_part(possible, p, q);
    return !possible.empty();
  });
  if (possible.empty()) return {};
  const Point centre = centroid_of(possible);
  return is_centre(corners, midpoints, centre) ? std::optional(centre) : std::nullopt;
}

}  // namespace anisofront
