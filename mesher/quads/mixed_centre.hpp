#pragma once

#include <optional>
#include <span>

#include "mesher/geometry/point.hpp"

namespace anisofront {

/// The vertex inside a face of n corners from which it is divided into n quadrilaterals (Fig. 11):
/// corner k, midpoint k (of the edge from corner k to the next), centre, midpoint k - 1.
/// It is the mean of the midpoints where that makes all of them strictly convex (exact predicate)
/// without flat corners, as for every convex face with midpoints on its straight edges; else a
/// point at which they are; nothing where there is none.
std::optional<Point> centre_of_division(std::span<const Point> corners,
                                        std::span<const Point> midpoints);

/// The mean of the midpoints.
Point mean_of(std::span<const Point> midpoints);

}  // namespace anisofront
