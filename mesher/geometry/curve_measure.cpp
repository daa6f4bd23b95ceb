// Length of NURBS curves and nearest points on them.
#include <algorithm>

#include "mesher/geometry/curve.hpp"
#include "mesher/geometry/curve_piece.hpp"
#include "mesher/geometry/quadrature.hpp"

namespace anisofront {
namespace {

constexpr double kLengthTolerance = 1e-12;  // of the length of a span

/// Length within one knot span; segments of degree 1 are straight whatever their weights.
double span_length(const NurbsCurve& curve, std::size_t span, double t0, double t1) {
  if (curve.degree == 1) return norm(evaluate(curve, t1) - evaluate(curve, t0));
  const auto speed = [&](double t) { return norm(detail::span_derivatives(curve, span, t).first); };
  const double whole = detail::gauss_8(speed, t0, t1);
  return detail::integrate(speed, t0, t1, kLengthTolerance * whole, whole);
}

}  // namespace

double arc_length(const NurbsCurve& curve, double t0, double t1) {
  const double begin = std::max(std::min(t0, t1), curve.begin_parameter());
  const double end = std::min(std::max(t0, t1), curve.end_parameter());
  double length = 0;
  for (std::size_t span = detail::find_span(curve, begin);
       span + 1 < curve.knots.size() && curve.knots[span] < end; ++span) {
    const double low = std::max(begin, curve.knots[span]);
    const double high = std::min(end, curve.knots[span + 1]);
    if (low < high) length += span_length(curve, span, low, high);
  }
  return length;
}

NearestPoint nearest_point(const NurbsCurve& curve, Point p) {
  NearestPoint best{.parameter = curve.begin_parameter(),
                    .point = curve.points.front(),
                    .distance = norm(p - curve.points.front())};
  for (const detail::CurvePiece& piece : detail::split_into_pieces(curve)) {
    if (detail::distance_bound(piece, p) >= best.distance) continue;
    const NearestPoint nearest = detail::nearest_on_piece(curve, piece, p);
    if (nearest.distance < best.distance) best = nearest;
  }
  return best;
}

}  // namespace anisofront
