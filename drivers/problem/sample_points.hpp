#pragma once

#include <span>
#include <string>
#include <vector>

#include "adapt/point_location.hpp"
#include "drivers/problem/line_points.hpp"

namespace anisofront {

/// All elements that contain a point, several on edges and at vertices: the states are averaged, so
/// that they do not depend on which element is found first.
using Places = std::vector<Location>;

/// A place where the solution is evaluated.
struct SamplePoint {
  Point at;
  Places places;
};

/// The points of a line with their elements on one mesh.
struct SampleLine {
  std::string name;
  LinePoints line;
  std::vector<Places> places;  ///< per point
};

struct SamplePoints {
  std::vector<SamplePoint> values;  ///< one per requested value
  std::vector<SampleLine> lines;
};

/// Finds the elements of everything that a study asks for. Points of curves are taken on the
/// nearest edge. Throws UsageError with the line of the study: unknown curves, and points that lie
/// outside the mesh by more than its edges lie off their curves (with the distance).
SamplePoints locate_requests(const OutputRequests& requests, const Domain& domain,
                             const FeMesh& mesh);

/// The same for points that are known to lie in the domain: on this mesh of it, each gets the
/// nearest place.
std::vector<Places> nearest_places(std::span<const Point> points, const FeMesh& mesh);

}  // namespace anisofront
