#pragma once

#include <string>
#include <vector>

#include "drivers/study/study_output.hpp"
#include "mesher/geometry/domain.hpp"

namespace anisofront {

/// Points along a line, run through from its start.
struct LinePoints {
  std::vector<Point> points;
  std::vector<double> lengths;  ///< from the start, along the line
  /// Unit tangent in the direction of the line; the normal (tangent.y, -tangent.x) lies to its
  /// right, outward on a boundary that runs anticlockwise.
  std::vector<Vector> tangents;
};

/// The shares of the length of a line at which its points lie, from 0 to 1.
std::vector<double> point_shares(const LineRequest& request);

/// The points that a study asks for. Throws UsageError with its line for curves that the domain
/// does not have.
LinePoints line_points(const LineRequest& request, const Domain& domain);

}  // namespace anisofront
