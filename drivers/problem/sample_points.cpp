#include "drivers/problem/sample_points.hpp"

#include <algorithm>
#include <cmath>

#include <spdlog/fmt/fmt.h>

#include "drivers/problem/element_patch.hpp"
#include "drivers/study/expression.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/mesh/boundary_domain.hpp"

namespace anisofront {
namespace {

/// The largest distance between the midpoints of the mesh edges and their curves: points of the
/// domain may lie outside the mesh by that much.
double curve_distance(const Domain& domain, const Mesh& mesh) {
  double largest = 0;
  for (const CurveEdge& edge : mesh.edges) {
    if (edge.curve < 0 || edge.curve >= static_cast<Index>(domain.curves.size())) continue;
    const NurbsCurve& curve = domain.curves[static_cast<std::size_t>(edge.curve)].curve;
    if (crosses_seam(curve, edge.parameters)) continue;
    const Point middle = lerp(mesh.points[static_cast<std::size_t>(edge.vertices[0])],
                              mesh.points[static_cast<std::size_t>(edge.vertices[1])], 0.5);
    const Point on_curve = evaluate(curve, (edge.parameters[0] + edge.parameters[1]) / 2);
    largest = std::max(largest, norm(on_curve - middle));
  }
  return largest;
}

/// Finds points and what lies around them.
class Sampler {
 public:
  explicit Sampler(const FeMesh& mesh) : location_(mesh), patches_(mesh) {}

  Places near(Point p) { return patches_.around(location_.nearest(p)); }

  /// `what` starts the message when p lies outside by more than the tolerance.
  void require_inside(Point p, double tolerance, const std::string& what) {
    if (location_.find(p, tolerance)) return;
    const Location nearest = location_.nearest(p);
    throw UsageError(fmt::format("{} at {} lies outside the domain, {:.4g} away from it", what,
                                 coordinates(p), norm(map_at(nearest.element, nearest.at).x - p)));
  }

 private:
  PointLocation location_;
  ElementPatches patches_;
};

std::vector<SamplePoint> locate_values(const std::vector<ValueRequest>& requests, double tolerance,
                                       const FeMesh& mesh) {
  std::vector<SamplePoint> points;
  Sampler sampler(mesh);
  for (const ValueRequest& value : requests) {
    sampler.require_inside(value.at, tolerance, fmt::format("{} \"{}\"", value.place, value.name));
    points.push_back({value.at, sampler.near(value.at)});
  }
  return points;
}

/// Curves belong to the domain, lines from point to point need not.
void require_inside(const LineRequest& request, const LinePoints& line, double tolerance,
                    const FeMesh& mesh) {
  if (!request.curve.empty()) return;
  Sampler sampler(mesh);
  for (std::size_t i = 0; i < line.points.size(); ++i)
    sampler.require_inside(
        line.points[i], tolerance,
        fmt::format("{} \"{}\": its point {}", request.place, request.name, i + 1));
}

}  // namespace

SamplePoints locate_requests(const OutputRequests& requests, const Domain& domain,
                             const FeMesh& mesh) {
  SamplePoints points;
  if (requests.values.empty() && requests.lines.empty()) return points;
  const double tolerance = curve_distance(domain, mesh.mesh);
  points.values = locate_values(requests.values, tolerance, mesh);
  for (const LineRequest& request : requests.lines) {
    LinePoints line = line_points(request, domain);
    require_inside(request, line, tolerance, mesh);
    std::vector<Places> places = nearest_places(line.points, mesh);
    points.lines.push_back({request.name, std::move(line), std::move(places)});
  }
  return points;
}

std::vector<Places> nearest_places(std::span<const Point> points, const FeMesh& mesh) {
  std::vector<Places> places;
  Sampler sampler(mesh);
  for (const Point p : points) places.push_back(sampler.near(p));
  return places;
}

}  // namespace anisofront
