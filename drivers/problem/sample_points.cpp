#include "drivers/problem/sample_points.hpp"

#include <algorithm>
#include <cmath>

#include <spdlog/fmt/fmt.h>

#include "drivers/problem/element_patch.hpp"
#include "drivers/study/domain_names.hpp"
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
  Sampler(const Domain& domain, const FeMesh& mesh)
      : location_(mesh), patches_(mesh), tolerance_(curve_distance(domain, mesh.mesh)) {}

  /// `what` starts the message when p lies outside.
  SamplePoint at(Point p, const std::string& what) {
    if (const auto place = location_.find(p, tolerance_)) return {p, patches_.around(*place)};
    const Location nearest = location_.nearest(p);
    throw UsageError(fmt::format("{} at {} lies outside the domain, {:.4g} away from it", what,
                                 coordinates(p), norm(map_at(nearest.element, nearest.at).x - p)));
  }

  SamplePoint near(Point p) { return {p, patches_.around(location_.nearest(p))}; }

 private:
  PointLocation location_;
  ElementPatches patches_;
  double tolerance_;
};

SampleLine straight_line(const LineRequest& request, Sampler& sampler) {
  SampleLine line{request.name, {}, {}, {}};
  const double length = norm(request.to - request.from);
  for (Index i = 0; i < request.points; ++i) {
    const double t = static_cast<double>(i) / (request.points - 1);
    // The ends as they stand in the study.
    const Point p = i + 1 == request.points ? request.to : lerp(request.from, request.to, t);
    line.points.push_back(
        sampler.at(p, fmt::format("{} \"{}\": its point {}", request.place, request.name, i + 1)));
    line.lengths.push_back(t * length);
    line.tangents.push_back((1 / length) * (request.to - request.from));
  }
  return line;
}

/// Parameters of points in equal steps of arc length.
std::vector<double> equal_steps(const NurbsCurve& curve, Index points, double& length) {
  constexpr int kPiecesPerSpan = 16;
  constexpr int kNewtonSteps = 3;
  std::vector<double> breaks, lengths{0};
  const std::vector<double> knots = distinct_knots(curve);
  for (std::size_t k = 0; k + 1 < knots.size(); ++k)
    for (int i = 0; i < kPiecesPerSpan; ++i)
      breaks.push_back(std::lerp(knots[k], knots[k + 1], i / double{kPiecesPerSpan}));
  breaks.push_back(knots.back());
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    lengths.push_back(lengths.back() + arc_length(curve, breaks[k], breaks[k + 1]));
  length = lengths.back();
  std::vector<double> parameters{breaks.front()};
  for (Index i = 1; i + 1 < points; ++i) {
    const double s = length * i / (points - 1);
    const auto k = static_cast<std::size_t>(
        std::upper_bound(lengths.begin(), lengths.end() - 1, s) - lengths.begin() - 1);
    double t =
        std::lerp(breaks[k], breaks[k + 1], (s - lengths[k]) / (lengths[k + 1] - lengths[k]));
    for (int step = 0; step < kNewtonSteps; ++step) {
      const double excess = lengths[k] + arc_length(curve, breaks[k], t) - s;
      t = std::clamp(t - excess / norm(derivatives(curve, t).first), breaks[k], breaks[k + 1]);
    }
    parameters.push_back(t);
  }
  parameters.push_back(breaks.back());
  return parameters;
}

SampleLine curve_line(const LineRequest& request, const Domain& domain, Sampler& sampler) {
  curve_tag(domain, request.curve, request.place + ".curve");  // refuses unknown names
  const NurbsCurve& curve =
      domain.curves[static_cast<std::size_t>(find_curve(domain, request.curve))].curve;
  SampleLine line{request.name, {}, {}, {}};
  double length = 0;
  for (const double t : equal_steps(curve, request.points, length)) {
    line.lengths.push_back(length * static_cast<double>(line.points.size()) / (request.points - 1));
    line.tangents.push_back(unit_tangent(curve, t));
    line.points.push_back(sampler.near(evaluate(curve, t)));
  }
  return line;
}

}  // namespace

SamplePoints locate_requests(const OutputRequests& requests, const Domain& domain,
                             const FeMesh& mesh) {
  SamplePoints points;
  if (requests.values.empty() && requests.lines.empty()) return points;
  Sampler sampler(domain, mesh);
  for (const ValueRequest& value : requests.values)
    points.values.push_back(
        sampler.at(value.at, fmt::format("{} \"{}\"", value.place, value.name)));
  for (const LineRequest& line : requests.lines)
    points.lines.push_back(line.curve.empty() ? straight_line(line, sampler)
                                              : curve_line(line, domain, sampler));
  return points;
}

}  // namespace anisofront
