#include "solver/space/element_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "solver/space/basis.hpp"

namespace anisofront {
namespace {

constexpr int kMaxNewtonSteps = 30;
/// Determinants below this share of their products are rounding.
constexpr double kFlat = 4 * std::numeric_limits<double>::epsilon();

template <int N>
MapPoint mapped_by(const Basis<N>& basis, const std::array<Point, 9>& nodes) {
  MapPoint map{};
  for (int k = 0; k < N; ++k) {
    map.x = map.x + basis.value[k] * nodes[k];
    map.d_xi = map.d_xi + basis.gradient[k].x * nodes[k];
    map.d_eta = map.d_eta + basis.gradient[k].y * nodes[k];
  }
  return map;
}

MapPoint affine_map(const Element& element, ReferencePoint at) {
  const Vector u = element.nodes[1] - element.nodes[0], v = element.nodes[2] - element.nodes[0];
  return {element.nodes[0] + at.xi * u + at.eta * v, u, v};
}

double diameter(const Element& element) {
  double squared = 0;
  for (int k = 0; k < element.corners; ++k)
    squared = std::max(squared,
                       squared_norm(element.nodes[(k + 1) % element.corners] - element.nodes[k]));
  return std::sqrt(squared);
}

}  // namespace

MapPoint map_at(const Element& element, ReferencePoint at) {
  if (element.shape == Shape::triangle)
    return element.bent ? mapped_by(quadratic_triangle(at), element.nodes)
                        : affine_map(element, at);
  return element.bent ? mapped_by(biquadratic_quad(at), element.nodes)
                      : mapped_by(bilinear_quad(at), element.nodes);
}

double positive_determinant(const MapPoint& map, const Element& element) {
  const double left = map.d_xi.x * map.d_eta.y, right = map.d_xi.y * map.d_eta.x;
  if (!(left - right > kFlat * (std::abs(left) + std::abs(right))))
    throw InputError("element " + std::to_string(element.number + 1) +
                     " is turned inside out or flat at " + describe(map.x) +
                     "; expected convex elements with anticlockwise corners");
  return left - right;
}

std::optional<ReferencePoint> inverse_map(const Element& element, Point p) {
  ReferencePoint at =
      element.shape == Shape::triangle ? ReferencePoint{1. / 3, 1. / 3} : ReferencePoint{0, 0};
  const bool affine = element.shape == Shape::triangle && !element.bent;
  for (int step = 0; step < kMaxNewtonSteps; ++step) {
    const MapPoint map = map_at(element, at);
    const double det = map.determinant();
    if (det == 0) return {};
    const Vector r = p - map.x;
    const double d_xi = cross(r, map.d_eta) / det, d_eta = cross(map.d_xi, r) / det;
    at.xi += d_xi;
    at.eta += d_eta;
    if (!std::isfinite(at.xi) || !std::isfinite(at.eta)) return {};
    if (affine ||
        std::abs(d_xi) + std::abs(d_eta) < 1e-14 * (1 + std::abs(at.xi) + std::abs(at.eta)))
      return at;
  }
  // Round-off of the coordinates may keep the last steps above the bound.
  const double miss = norm(p - map_at(element, at).x);
  return miss <= 1e-12 * (diameter(element) + norm(p)) ? std::optional(at) : std::nullopt;
}

ReferencePoint clamped(Shape shape, ReferencePoint at) {
  if (shape == Shape::quadrilateral)
    return {std::clamp(at.xi, -1., 1.), std::clamp(at.eta, -1., 1.)};
  at = {std::max(at.xi, 0.), std::max(at.eta, 0.)};
  const double excess = at.xi + at.eta - 1;
  if (excess <= 0) return at;
  const double xi = std::clamp(at.xi - 0.5 * excess, 0., 1.);
  return {xi, 1 - xi};
}

CurvePoint curve_point(const FeMesh& mesh, Index curve_edge, double t) {
  const CurveEdge& edge = mesh.mesh.edges[curve_edge];
  const Index number = mesh.edges.curve_edges[curve_edge];
  const Point a = mesh.mesh.points[edge.vertices[0]], b = mesh.mesh.points[edge.vertices[1]];
  const Point middle = mesh.edge_points[number];
  // x = (1 - t) a + t b + 4 t (1 - t) bend; the bend of a straight edge is exactly zero.
  const Vector bend = mesh.edge_is_bent[number] ? middle - lerp(a, b, 0.5) : Vector{};
  const Vector derivative = b - a + (4 - 8 * t) * bend;
  const double speed = norm(derivative);
  return {lerp(a, b, t) + 4 * t * (1 - t) * bend, (1 / speed) * derivative, speed};
}

}  // namespace anisofront
