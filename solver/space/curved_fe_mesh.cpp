#include <array>
#include <cmath>
#include <string>

#include "mesher/mesh/boundary_domain.hpp"
#include "solver/space/element_map.hpp"
#include "solver/space/fe_mesh.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

/// A bend below this share of the chord is rounding: the edge is straight.
constexpr double kLeastBend = 1e-10;
/// The determinant of a bent element may fall to this share of that of the straight one.
constexpr double kLeastDeterminant = 0.2;
/// Tangents are taken this share of the edge inside its ends, so that a corner of the curve there
/// gives the tangent of the right side.
constexpr double kInside = 1e-11;

/// The part of a curve under an edge as a function of s in [0, 1].
struct CurvePart {
  const NurbsCurve& curve;
  double t0, t1;  ///< t1 may lie outside the range of a closed curve, which then goes on

  double parameter(double s) const {
    const double begin = curve.begin_parameter(), end = curve.end_parameter();
    const double t = t0 + s * (t1 - t0);
    return t < begin ? t + (end - begin) : t > end ? t - (end - begin) : t;
  }
  Point point(double s) const { return evaluate(curve, parameter(s)); }
  Vector tangent(double s) const {
    const Vector along = unit_tangent(curve, parameter(s));
    return t1 >= t0 ? along : -along;
  }
};

CurvePart part_under(const NurbsCurve& curve, const CurveEdge& edge) {
  auto [t0, t1] = edge.parameters;
  const double range = curve.end_parameter() - curve.begin_parameter();
  if (crosses_seam(curve, edge.parameters)) t1 += t1 > t0 ? -range : range;
  return {curve, t0, t1};
}

/// Where the normal of the chord ab through its midpoint meets the curve, by bisection.
Point bend_point(const CurvePart& part, Point a, Point b) {
  const Point middle = lerp(a, b, 0.5);
  double low = 0, high = 1;
  for (int step = 0; step < 60; ++step) {
    const double s = 0.5 * (low + high);
    (dot(part.point(s) - middle, b - a) < 0 ? low : high) = s;
  }
  const Point p = part.point(0.5 * (low + high));
  // Only the offset is of interest; along the chord the midpoint is exact.
  const Vector normal{a.y - b.y, b.x - a.x};
  return middle + (dot(p - middle, normal) / squared_norm(normal)) * normal;
}

void bend_edges(const Domain& domain, FeMesh& fe) {
  for (std::size_t i = 0; i < fe.mesh.edges.size(); ++i) {
    const CurveEdge& edge = fe.mesh.edges[i];
    if (edge.curve < 0 || edge.curve >= static_cast<Index>(domain.curves.size())) continue;
    const NurbsCurve& curve = domain.curves[edge.curve].curve;
    if (curve.degree == 1 || edge.parameters[0] == edge.parameters[1]) continue;
    const CurvePart part = part_under(curve, edge);
    fe.curve_tangents[i] = {part.tangent(kInside), part.tangent(1 - kInside)};
    const Point a = fe.mesh.points[edge.vertices[0]], b = fe.mesh.points[edge.vertices[1]];
    const Point p = bend_point(part, a, b);
    if (norm(p - lerp(a, b, 0.5)) <= kLeastBend * norm(b - a)) continue;
    fe.edge_points[fe.edges.curve_edges[i]] = p;
    fe.edge_is_bent[fe.edges.curve_edges[i]] = 1;
  }
}

bool is_valid(const Element& element, const std::vector<char>& edge_is_bent) {
  Element straight = element;
  straight.bent = false;
  const auto holds = [&](ReferencePoint at) {
    return map_at(element, at).determinant() >
           kLeastDeterminant * map_at(straight, at).determinant();
  };
  for (const WeightedPoint& q : reference_quadrature(element.shape, 6))
    if (!holds(q.at)) return false;
  constexpr std::array<ReferencePoint, 3> kTriangle{{{0, 0}, {1, 0}, {0, 1}}};
  constexpr std::array<ReferencePoint, 4> kSquare{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (int k = 0; k < element.corners; ++k) {
    // A corner between two edges of one smooth curve is flat, and harmless: no rule has a point
    // there.
    const int before = (k + element.corners - 1) % element.corners;
    if (edge_is_bent[element.edges[k]] && edge_is_bent[element.edges[before]]) continue;
    if (!holds(element.corners == 3 ? kTriangle[k] : kSquare[k])) return false;
  }
  return true;
}

/// Straightens the bent edges of elements that are turned inside out or nearly so, until none is.
/// Returns the number of edges.
int straighten_invalid(FeMesh& fe) {
  int straightened = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (Index e = 0; e < fe.element_count(); ++e) {
      const Element element = element_at(fe, e);
      if (!element.bent || is_valid(element, fe.edge_is_bent)) continue;
      for (int k = 0; k < element.corners; ++k) {
        const Index edge = element.edges[k];
        if (!fe.edge_is_bent[edge]) continue;
        const auto& [a, b] = fe.edges.vertices[edge];
        fe.edge_points[edge] = lerp(fe.mesh.points[a], fe.mesh.points[b], 0.5);
        fe.edge_is_bent[edge] = 0;
        ++straightened;
        changed = true;
      }
    }
  }
  return straightened;
}

}  // namespace

FeMesh curved_fe_mesh(const Mesh& mesh, const Domain& domain, const Monitor& monitor) {
  FeMesh fe = straight_fe_mesh(mesh);
  bend_edges(domain, fe);
  if (const int count = straighten_invalid(fe); count > 0)
    monitor.warning(std::to_string(count) +
                    " edges on curves stay straight because elements next to them are thinner than "
                    "the bend; a smaller size along the curve avoids this");
  return fe;
}

}  // namespace anisofront
