#pragma once

#include <span>
#include <vector>

#include "mesher/geometry/point.hpp"

namespace anisofront {

/// Non-uniform rational B-spline curve in the plane, of any degree >= 1.
/// knots: points.size() + degree + 1 values, non-decreasing, clamped at both ends;
/// weights: one positive value per control point.
struct NurbsCurve {
  int degree = 1;
  std::vector<double> knots;
  std::vector<double> weights;
  std::vector<Point> points;

  double begin_parameter() const { return knots[static_cast<std::size_t>(degree)]; }
  double end_parameter() const {
    return knots[knots.size() - 1 - static_cast<std::size_t>(degree)];
  }
};

/// Throws InputError saying which of the conditions above is broken (non-finite values included).
void validate(const NurbsCurve& curve);

/// Point of the curve at t; t is clamped to the parameter range. The two ends are exact.
Point evaluate(const NurbsCurve& curve, double t);

struct CurveDerivatives {
  Point point;
  Vector first;
  Vector second;
};
/// Point and the first two derivatives with respect to the parameter (right-sided at inner knots).
CurveDerivatives derivatives(const NurbsCurve& curve, double t);

/// Signed curvature (positive: turning left), 1/length; 0 where the first derivative vanishes.
double curvature(const NurbsCurve& curve, double t);

/// Length of the curve between two parameters in any order (>= 0), relative accuracy about 1e-10.
/// Exact up to rounding for degree 1.
double arc_length(const NurbsCurve& curve, double t0, double t1);

struct NearestPoint {
  double parameter = 0;
  Point point;
  double distance = 0;
};
/// The point of the curve nearest to p (global: the curve is cut into pieces of little turning,
/// those that may be nearest are refined by Newton's method). O(number of knot spans) at each
/// call: use CurveLocator (curve_locator.hpp) for many points.
NearestPoint nearest_point(const NurbsCurve& curve, Point p);

/// Parameters of the breaks of smoothness or of the knot spans: ascending, both ends included.
std::vector<double> distinct_knots(const NurbsCurve& curve);

/// A point where a curve turns at once.
struct CurveKink {
  double parameter = 0;
  Point point;
};
/// The inner points where the tangent turns by more than `angle` degrees: ascending.
std::vector<CurveKink> kinks(const NurbsCurve& curve, double angle);

/// True when the first and last point coincide exactly.
bool is_closed(const NurbsCurve& curve);

/// Unit tangent at t (one-sided at the ends and at corners: towards larger t).
Vector unit_tangent(const NurbsCurve& curve, double t);

/// The same curve traversed backwards: evaluate(reversed(c), a + b - t) == evaluate(c, t).
NurbsCurve reversed(const NurbsCurve& curve);

// Constructors. Angles are in radians, anticlockwise from the x axis (of the ellipse). They throw
// InputError for non-finite numbers, radii <= 0, fewer than two vertices, equal neighbours and
// arcs of no or more than one turn.
NurbsCurve make_line(Point a, Point b);
/// Degree 1, one knot span per segment, parameter 0..n-1 (vertex k sits at t = k).
NurbsCurve make_polyline(std::span<const Point> vertices);
/// Rational quadratic pieces of at most 90 degrees, parameter k at the end of piece k; clockwise
/// when end_angle < start_angle.
NurbsCurve make_arc(Point centre, double radius, double start_angle, double end_angle);
/// Anticlockwise from the point at angle 0; parameter 0..4, one unit per quarter.
NurbsCurve make_circle(Point centre, double radius);
/// rotation: angle of the first semi-axis; the full ellipse, anticlockwise.
NurbsCurve make_ellipse(Point centre, double radius1, double radius2, double rotation = 0);
/// What a spline does where its first and last vertex coincide.
enum class SplineSeam { smooth, corner };
/// Cubic curve through the vertices with continuous tangent direction (G1), parameter k at vertex
/// k; when first == last the tangent is continuous there too, unless `seam` is a corner. Tangents
/// are those of the circles through three neighbours: vertices on a circle give a curve within
/// O(h^6) of it, vertices on a line the line.
NurbsCurve make_spline(std::span<const Point> vertices, SplineSeam seam = SplineSeam::smooth);

}  // namespace anisofront
