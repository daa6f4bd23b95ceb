// Evaluation of NURBS curves by de Boor's algorithm on homogeneous control points.
// Reference: L. Piegl, W. Tiller, The NURBS Book, 2nd ed., Springer 1997,
// doi:10.1007/978-3-642-59223-2.
#include "mesher/geometry/curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mesher/geometry/curve_piece.hpp"
#include "mesher/geometry/de_boor.hpp"
#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

using detail::DeBoor;
using detail::Homogeneous;

Point project(Homogeneous h) { return {h.x / h.w, h.y / h.w}; }

Homogeneous scaled_difference(double factor, Homogeneous a, Homogeneous b) {
  return {factor * (a.x - b.x), factor * (a.y - b.y), factor * (a.w - b.w)};
}

[[noreturn]] void reject(const std::string& found, const std::string& expected) {
  throw InputError("NURBS curve: " + found + "; expected " + expected);
}

void validate_sizes(const NurbsCurve& curve) {
  if (curve.degree < 1) reject("degree " + std::to_string(curve.degree), "a degree of at least 1");
  const auto degree = static_cast<std::size_t>(curve.degree);
  const std::size_t count = curve.points.size();
  if (count < degree + 1)
    reject(std::to_string(count) + " control points",
           "at least degree + 1 = " + std::to_string(degree + 1));
  if (curve.weights.size() != count)
    reject(std::to_string(curve.weights.size()) + " weights",
           "one per control point (" + std::to_string(count) + ")");
  if (curve.knots.size() != count + degree + 1)
    reject(std::to_string(curve.knots.size()) + " knots",
           "control points + degree + 1 = " + std::to_string(count + degree + 1));
}

void validate_knots(const NurbsCurve& curve) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  const std::vector<double>& knots = curve.knots;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i])) reject("knot " + std::to_string(i) + " is not finite", "numbers");
    if (i > 0 && knots[i] < knots[i - 1])
      reject("knot " + std::to_string(i) + " = " + describe(knots[i]) + " after " +
                 describe(knots[i - 1]),
             "non-decreasing knots");
  }
  if (knots[0] != knots[degree] || knots.back() != knots[knots.size() - 1 - degree])
    reject("knots that are not clamped", "degree + 1 equal knots at both ends");
  for (std::size_t i = 1; i + degree + 1 < knots.size(); ++i)
    if (knots[i] == knots[i + degree])
      reject("knot " + describe(knots[i]) + " occurs more than degree times",
             "a multiplicity of at most the degree (the curve would be torn)");
}

void validate_points(const NurbsCurve& curve) {
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Point p = curve.points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y))
      reject("control point " + std::to_string(i) + " = " + describe(p), "finite coordinates");
    if (!std::isfinite(curve.weights[i]) || curve.weights[i] <= 0)
      reject("weight " + std::to_string(i) + " = " + describe(curve.weights[i]),
             "positive finite weights");
  }
}

/// Direction of a vector, zero for the zero vector.
Vector direction(Vector v) {
  const double length = norm(v);
  return length > 0 ? (1 / length) * v : Vector{};
}

}  // namespace

namespace detail {

std::size_t find_span(const NurbsCurve& curve, double t) {
  const auto degree = static_cast<std::ptrdiff_t>(curve.degree);
  const auto begin = curve.knots.begin() + degree, end = curve.knots.end() - degree - 1;
  const auto above = std::upper_bound(begin, end, t);
  return static_cast<std::size_t>(std::max(above, begin + 1) - curve.knots.begin() - 1);
}

CurveDerivatives span_derivatives(const NurbsCurve& curve, std::size_t span, double t) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  const std::vector<double>& u = curve.knots;
  DeBoor scheme(curve, span);
  for (std::size_t level = 1; level + 1 < degree; ++level) scheme.step(level, t);
  Homogeneous second{0, 0, 0};
  if (degree >= 2) {  // derivative of the derivative curve, The NURBS Book, Eqn (3.8)
    const Homogeneous before =
        scaled_difference(1 / (u[span + 1] - u[span - 1]), scheme[degree - 1], scheme[degree - 2]);
    const Homogeneous after =
        scaled_difference(1 / (u[span + 2] - u[span]), scheme[degree], scheme[degree - 1]);
    const double factor = static_cast<double>(degree * (degree - 1)) / (u[span + 1] - u[span]);
    second = scaled_difference(factor, after, before);
    scheme.step(degree - 1, t);
  }
  const Homogeneous first = scaled_difference(static_cast<double>(degree) / (u[span + 1] - u[span]),
                                              scheme[degree], scheme[degree - 1]);
  scheme.step(degree, t);
  const double w = scheme[degree].w;
  CurveDerivatives result;  // quotient rule, The NURBS Book, Eqn (4.8)
  result.point = project(scheme[degree]);
  result.first = (1 / w) * (Vector{first.x, first.y} - first.w * result.point);
  result.second =
      (1 / w) * (Vector{second.x, second.y} - 2 * first.w * result.first - second.w * result.point);
  return result;
}

}  // namespace detail

void validate(const NurbsCurve& curve) {
  validate_sizes(curve);
  validate_knots(curve);
  validate_points(curve);
}

Point evaluate(const NurbsCurve& curve, double t) {
  if (t <= curve.begin_parameter()) return curve.points.front();
  if (t >= curve.end_parameter()) return curve.points.back();
  const std::size_t span = detail::find_span(curve, t);
  const auto degree = static_cast<std::size_t>(curve.degree);
  DeBoor scheme(curve, span);
  for (std::size_t level = 1; level <= degree; ++level) scheme.step(level, t);
  return project(scheme[degree]);
}

CurveDerivatives derivatives(const NurbsCurve& curve, double t) {
  const double inside = std::clamp(t, curve.begin_parameter(), curve.end_parameter());
  CurveDerivatives result =
      detail::span_derivatives(curve, detail::find_span(curve, inside), inside);
  result.point = evaluate(curve, inside);
  return result;
}

double curvature(const NurbsCurve& curve, double t) {
  const CurveDerivatives d = derivatives(curve, t);
  const double speed = norm(d.first);
  return speed > 0 ? cross(d.first, d.second) / (speed * speed * speed) : 0;
}

std::vector<CurveKink> kinks(const NurbsCurve& curve, double angle) {
  const double least_cosine = std::cos(angle * std::numbers::pi / 180);
  const auto degree = static_cast<std::size_t>(curve.degree);
  std::vector<CurveKink> found;
  // An inner knot as often as the degree: the curve runs through control point k - 1.
  for (std::size_t k = degree + 1; k < curve.points.size(); ++k) {
    const double t = curve.knots[k];
    if (t == curve.knots[k - 1] || curve.knots[k + degree - 1] != t) continue;
    const Vector in = curve.points[k - 1] - curve.points[k - 2];
    const Vector out = curve.points[k] - curve.points[k - 1];
    if (dot(in, out) < least_cosine * norm(in) * norm(out))
      found.push_back({t, curve.points[k - 1]});
  }
  return found;
}

std::vector<double> distinct_knots(const NurbsCurve& curve) {
  std::vector<double> result = curve.knots;
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

bool is_closed(const NurbsCurve& curve) { return curve.points.front() == curve.points.back(); }

Vector unit_tangent(const NurbsCurve& curve, double t) {
  const CurveDerivatives d = derivatives(curve, t);
  const bool at_end = t >= curve.end_parameter();
  Vector tangent = direction(d.first);
  // Where the first derivative vanishes the second one gives the limit direction.
  if (tangent == Vector{}) tangent = direction(at_end ? -d.second : d.second);
  if (tangent != Vector{}) return tangent;
  const double step = 1e-6 * (curve.end_parameter() - curve.begin_parameter());
  return direction(at_end ? d.point - evaluate(curve, t - step)
                          : evaluate(curve, t + step) - d.point);
}

NurbsCurve reversed(const NurbsCurve& curve) {
  NurbsCurve result = curve;
  std::reverse(result.points.begin(), result.points.end());
  std::reverse(result.weights.begin(), result.weights.end());
  std::reverse(result.knots.begin(), result.knots.end());
  const double sum = curve.begin_parameter() + curve.end_parameter();
  for (double& knot : result.knots) knot = sum - knot;
  return result;
}

}  // namespace anisofront
