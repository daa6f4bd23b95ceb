#include "mesher/geometry/curve_piece.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/geometry/de_boor.hpp"

namespace anisofront::detail {
namespace {

constexpr double kMaxTurning = 0.45;  // radians; 16 pieces per circle
constexpr int kMaxDepth = 8;          // halvings of a span; only cusps reach it

double distance_to_segment(Point a, Point b, Point p) {
  const Vector chord = b - a;
  const double length2 = squared_norm(chord);
  const double s = length2 > 0 ? std::clamp(dot(p - a, chord) / length2, 0.0, 1.0) : 0;
  return norm(p - lerp(a, b, s));
}

/// Control points of the rational Bezier curve that equals the curve on [t0, t1] within a span:
/// the k-th is the blossom of degree - k times t0 and k times t1 (The NURBS Book, section 5.3).
std::vector<Point> bezier_points(const NurbsCurve& curve, std::size_t span, double t0, double t1) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  std::vector<Point> points(degree + 1);
  for (std::size_t k = 0; k <= degree; ++k) {
    DeBoor scheme(curve, span);
    for (std::size_t level = 1; level <= degree; ++level)
      scheme.step(level, level + k <= degree ? t0 : t1);
    points[k] = {scheme[degree].x / scheme[degree].w, scheme[degree].y / scheme[degree].w};
  }
  return points;
}

/// Sum of the angles between the legs of a polygon: bounds the turning of the curve it controls.
double turning(const std::vector<Point>& polygon) {
  double sum = 0;
  Vector before{};
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    const Vector leg = polygon[i] - polygon[i - 1];
    if (leg == Vector{}) continue;
    if (before != Vector{}) sum += std::fabs(std::atan2(cross(before, leg), dot(before, leg)));
    before = leg;
  }
  return sum;
}

CurvePiece make_piece(const NurbsCurve& curve, std::size_t span, double t0, double t1,
                      const std::vector<Point>& control) {
  CurvePiece piece;
  piece.span = span;
  piece.t0 = t0;
  piece.t1 = t1;
  piece.p0 = control.front();
  piece.p1 = control.back();
  piece.tangent0 = span_derivatives(curve, span, t0).first;
  piece.tangent1 = span_derivatives(curve, span, t1).first;
  for (const Point p : control) {
    piece.box.add(p);
    piece.deviation = std::max(piece.deviation, distance_to_segment(piece.p0, piece.p1, p));
  }
  return piece;
}

void split(const NurbsCurve& curve, std::size_t span, double t0, double t1, int depth,
           std::vector<CurvePiece>& pieces) {
  const std::vector<Point> control = bezier_points(curve, span, t0, t1);
  if (depth == kMaxDepth || turning(control) <= kMaxTurning) {
    pieces.push_back(make_piece(curve, span, t0, t1, control));
    return;
  }
  const double middle = 0.5 * (t0 + t1);
  split(curve, span, t0, middle, depth + 1, pieces);
  split(curve, span, middle, t1, depth + 1, pieces);
}

NearestPoint nearest_on_segment(const NurbsCurve& curve, const CurvePiece& piece, Point p) {
  const Vector chord = piece.p1 - piece.p0;
  const double length2 = squared_norm(chord);
  const double s = length2 > 0 ? std::clamp(dot(p - piece.p0, chord) / length2, 0.0, 1.0) : 0;
  // The parameter runs along the chord like s where both weights are equal.
  const double w0 = curve.weights[piece.span - 1], w1 = curve.weights[piece.span];
  const double a = s * w0 / (s * w0 + (1 - s) * w1);
  const Point point = s == 1 ? piece.p1 : lerp(piece.p0, piece.p1, s);
  return {a == 1 ? piece.t1 : piece.t0 + a * (piece.t1 - piece.t0), point, norm(p - point)};
}

/// Root of f(t) = (C - p) . C' between t0 (f < 0) and t1 (f > 0) by safeguarded Newton steps
/// (The NURBS Book, Eqn 6.4).
NearestPoint nearest_inside(const NurbsCurve& curve, const CurvePiece& piece, Point p, double f0,
                            double f1) {
  double low = piece.t0, high = piece.t1;
  double t = low + (high - low) * f0 / (f0 - f1);
  NearestPoint result;
  for (int iteration = 0; iteration < 40; ++iteration) {
    const CurveDerivatives d = span_derivatives(curve, piece.span, t);
    const Vector offset = d.point - p;
    const double f = dot(offset, d.first);
    const double slope = squared_norm(d.first) + dot(offset, d.second);
    result = {t, d.point, norm(offset)};
    (f < 0 ? low : high) = t;
    double next = slope > 0 ? t - f / slope : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (f == 0 || std::fabs(next - t) <= 1e-14 * (piece.t1 - piece.t0)) break;
    t = next;
  }
  return result;
}

}  // namespace

void Box::add(Point p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

void Box::add(const Box& other) {
  add(other.low);
  add(other.high);
}

double Box::distance(Point p) const {
  const double dx = std::max({low.x - p.x, 0.0, p.x - high.x});
  const double dy = std::max({low.y - p.y, 0.0, p.y - high.y});
  return std::sqrt(dx * dx + dy * dy);
}

std::vector<CurvePiece> split_into_pieces(const NurbsCurve& curve) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  std::vector<CurvePiece> pieces;
  for (std::size_t span = degree; span + degree + 1 < curve.knots.size(); ++span)
    if (curve.knots[span] < curve.knots[span + 1])
      split(curve, span, curve.knots[span], curve.knots[span + 1], 0, pieces);
  // Neighbours share their end point exactly, and the ends are those of evaluate().
  for (std::size_t i = 1; i < pieces.size(); ++i) pieces[i].p0 = pieces[i - 1].p1;
  pieces.front().p0 = curve.points.front();
  pieces.back().p1 = curve.points.back();
  return pieces;
}

double distance_bound(const CurvePiece& piece, Point p) {
  return distance_to_segment(piece.p0, piece.p1, p) - piece.deviation;
}

NearestPoint nearest_on_piece(const NurbsCurve& curve, const CurvePiece& piece, Point p) {
  if (curve.degree == 1) return nearest_on_segment(curve, piece, p);
  NearestPoint best{piece.t0, piece.p0, norm(p - piece.p0)};
  const double end_distance = norm(p - piece.p1);
  if (end_distance < best.distance) best = {piece.t1, piece.p1, end_distance};
  const double f0 = dot(piece.p0 - p, piece.tangent0), f1 = dot(piece.p1 - p, piece.tangent1);
  if (f0 < 0 && f1 > 0) {
    const NearestPoint inside = nearest_inside(curve, piece, p, f0, f1);
    if (inside.distance < best.distance) best = inside;
  }
  return best;
}

}  // namespace anisofront::detail
