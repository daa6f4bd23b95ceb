#pragma once

#include <string>
#include <vector>

#include "adapt/point_location.hpp"
#include "drivers/study/study_output.hpp"

namespace anisofront {

/// A place where the solution is evaluated.
struct SamplePoint {
  Point at;
  /// All elements that contain it, several on edges and at vertices: the states are averaged, so
  /// that they do not depend on which element is found first.
  std::vector<Location> places;
};

/// Points along a line, run through from its start.
struct SampleLine {
  std::string name;
  std::vector<SamplePoint> points;
  std::vector<double> lengths;  ///< from the start, along the line
  /// Unit tangent in the direction of the line; the normal (tangent.y, -tangent.x) lies to its
  /// right, outward on a boundary that runs anticlockwise.
  std::vector<Vector> tangents;
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

}  // namespace anisofront
