#include "adapt/point_location.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "solver/scalar/reference_side.hpp"

namespace anisofront {
namespace {

constexpr double kBoundaryTolerance = 1e-9;
/// Reference coordinates may lie outside by rounding.
constexpr double kInside = 1e-12;

bool is_inside(Shape shape, ReferencePoint at) {
  if (shape == Shape::quadrilateral)
    return std::max(std::abs(at.xi), std::abs(at.eta)) <= 1 + kInside;
  return std::min(at.xi, at.eta) >= -kInside && at.xi + at.eta <= 1 + kInside;
}

std::optional<ReferencePoint> inside_element(const Element& element, Point p) {
  const auto at = inverse_map(element, p);
  if (!at || !is_inside(element.shape, *at)) return {};
  return clamped(element.shape, *at);
}

/// Where f is least in [0, 1]: the best of some samples, refined by golden sections.
template <class Function>
double minimum_on_unit_interval(const Function& f) {
  constexpr int kSamples = 16;
  constexpr double kGolden = 0.6180339887498949;
  int best = 0;
  for (int k = 1; k <= kSamples; ++k)
    if (f(1. * k / kSamples) < f(1. * best / kSamples)) best = k;
  double low = std::max(best - 1, 0) * (1. / kSamples);
  double high = std::min(best + 1, kSamples) * (1. / kSamples);
  for (int step = 0; step < 50; ++step) {
    const double width = kGolden * (high - low);
    if (f(high - width) <= f(low + width))
      high = low + width;
    else
      low = high - width;
  }
  return 0.5 * (low + high);
}

double nearest_on_side(const Element& element, int k, Point p) {
  const ReferenceSide side(element.shape, k);
  if (element.bent)
    return minimum_on_unit_interval(
        [&](double s) { return squared_norm(map_at(element, side.at(s)).x - p); });
  const Point a = element.nodes[k], b = element.nodes[(k + 1) % element.corners];
  return std::clamp(dot(p - a, b - a) / squared_norm(b - a), 0., 1.);
}

ReferencePoint nearest_on_sides(const Element& element, Point p) {
  ReferencePoint nearest;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < element.corners; ++k) {
    const ReferencePoint at = ReferenceSide(element.shape, k).at(nearest_on_side(element, k, p));
    const double distance = squared_norm(map_at(element, at).x - p);
    if (distance >= least) continue;
    least = distance;
    nearest = at;
  }
  return nearest;
}

bool has_bent_edges(const FeMesh& mesh) {
  return std::any_of(mesh.edge_is_bent.begin(), mesh.edge_is_bent.end(),
                     [](char bent) { return bent != 0; });
}

}  // namespace

PointLocation::PointLocation(const FeMesh& mesh)
    : mesh_(mesh), background_(mesh.mesh, MetricField(mesh.mesh.points.size())) {
  if (has_bent_edges(mesh)) stars_ = vertex_stars(mesh.mesh);
}

/// Elements that share a vertex with this one: a bent edge shifts points between neighbours.
PointLocation::Found PointLocation::nearest_around(const Element& element, Point p) const {
  Found best{{element, {}}, std::numeric_limits<double>::infinity()};
  for (int k = 0; k < element.corners; ++k)
    for (Index i = stars_.first[element.vertices[k]]; i < stars_.first[element.vertices[k] + 1];
         ++i) {
      const Element other = element_at(mesh_, stars_.elements[i]);
      if (const auto at = inside_element(other, p)) return {{other, *at}, 0};
      const ReferencePoint at = nearest_on_sides(other, p);
      const double distance = norm(map_at(other, at).x - p);
      if (distance < best.distance) best = {{other, at}, distance};
    }
  return best;
}

PointLocation::Found PointLocation::search(Point p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y))
    throw InputError("cannot locate the point " + describe(p) +
                     " in the mesh: expected finite coordinates");
  const auto [triangle, point] = background_.nearest(p, hint_);
  hint_ = triangle;
  const Element element = element_at(mesh_, background_.element_of(triangle));
  const bool is_outside = !(point == p);
  if (!stars_.first.empty() && (element.bent || is_outside)) {
    if (const auto at = inside_element(element, p)) return {{element, *at}, 0};
    return nearest_around(element, p);
  }
  if (const auto at = inside_element(element, point)) return {{element, *at}, norm(p - point)};
  const ReferencePoint at = nearest_on_sides(element, point);
  return {{element, at}, norm(map_at(element, at).x - p)};
}

std::optional<Location> PointLocation::find(Point p, double tolerance) {
  const Box& box = background_.bounds();
  const double least = kBoundaryTolerance * norm(box.high - box.low);
  const Found found = search(p);
  if (found.distance > (tolerance > 0 ? tolerance : least)) return {};
  return found.location;
}

Location PointLocation::nearest(Point p) { return search(p).location; }

}  // namespace anisofront
