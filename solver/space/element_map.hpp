#pragma once

#include <optional>

#include "solver/space/fe_mesh.hpp"

namespace anisofront {

/// Coordinates on the reference element: the triangle (0,0), (1,0), (0,1) or the square [-1, 1]^2.
struct ReferencePoint {
  double xi = 0;
  double eta = 0;
};

/// The map of an element at a reference point: x and the rows of J[a][b] = dx_b / dxi_a.
struct MapPoint {
  Point x;
  Vector d_xi;   ///< dx/dxi
  Vector d_eta;  ///< dx/deta

  double determinant() const { return cross(d_xi, d_eta); }
  /// J^-1 g: the gradient in x of a function whose reference gradient is g.
  Vector gradient(Vector g) const {
    const double s = 1 / determinant();
    return {s * (d_eta.y * g.x - d_xi.y * g.y), s * (d_xi.x * g.y - d_eta.x * g.x)};
  }
  /// J v: the covariant components of a physical vector.
  Vector covariant(Vector v) const { return {dot(d_xi, v), dot(d_eta, v)}; }
};

/// Linear or bilinear on straight elements, of second degree on bent ones.
MapPoint map_at(const Element& element, ReferencePoint at);

/// The determinant of a map of the element. Throws InputError naming element and place unless it is
/// positive beyond doubt: the element is turned inside out there, or flat to round-off.
double positive_determinant(const MapPoint& map, const Element& element);

/// The reference point that is mapped to p, by Newton steps from the centre; it may lie outside the
/// reference element. Empty when the steps do not converge (p far from a distorted element).
std::optional<ReferencePoint> inverse_map(const Element& element, Point p);

/// The nearest point of the reference element in its own coordinates (clamped), for points found
/// outside by rounding or by a bent boundary.
ReferencePoint clamped(Shape shape, ReferencePoint at);

/// A point of a curve edge, run through from t = 0 at vertices[0] to t = 1 at vertices[1].
struct CurvePoint {
  Point x;
  Vector tangent;    ///< unit; the outward normal of an outer boundary is (tangent.y, -tangent.x)
  double speed = 0;  ///< ds / dt
};
CurvePoint curve_point(const FeMesh& mesh, Index curve_edge, double t);

}  // namespace anisofront
