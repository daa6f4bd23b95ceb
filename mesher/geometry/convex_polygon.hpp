#pragma once

#include <vector>

#include "mesher/geometry/point.hpp"

namespace anisofront {

/// The part of a convex polygon (anticlockwise corners) to the left of the directed line pq or on
/// it, itself convex; empty when nothing is.
std::vector<Point> left_part(const std::vector<Point>& polygon, Point p, Point q);

}  // namespace anisofront
