#pragma once

#include <limits>
#include <vector>

#include "mesher/geometry/curve.hpp"

namespace anisofront::detail {

/// Axis-parallel box; empty until a point is added.
struct Box {
  Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(Point p);
  void add(const Box& other);
  /// Distance from p to the box, 0 inside.
  double distance(Point p) const;
  double diagonal() const { return norm(high - low); }
};

/// Index k of the knot span that holds t: knots[k] <= t < knots[k + 1], the last one at the end.
std::size_t find_span(const NurbsCurve& curve, double t);

/// Point and derivatives from the rational polynomial of one knot span (so one-sided at its ends).
CurveDerivatives span_derivatives(const NurbsCurve& curve, std::size_t span, double t);

/// A part of one knot span on which the tangent turns little.
struct CurvePiece {
  std::size_t span = 0;
  double t0 = 0, t1 = 0;
  Point p0, p1;
  Vector tangent0, tangent1;  ///< first derivatives at both ends, from inside
  Box box;                    ///< holds the piece (convex hull property)
  double deviation = 0;       ///< no point of the piece is further than this from the chord p0 p1
};

/// Cuts the curve into pieces whose control polygons turn by at most 0.45 rad, in parameter order.
/// Degree 1: one piece per segment.
std::vector<CurvePiece> split_into_pieces(const NurbsCurve& curve);

/// Lower bound of the distance from p to the piece.
double distance_bound(const CurvePiece& piece, Point p);

/// The point of the piece nearest to p.
NearestPoint nearest_on_piece(const NurbsCurve& curve, const CurvePiece& piece, Point p);

}  // namespace anisofront::detail
