// Lines, conics and splines as NURBS curves.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "mesher/geometry/curve.hpp"
#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

constexpr double kPi = std::numbers::pi;

/// Knots of `count` Bezier pieces: parameter 0..count, inner multiplicity = degree.
std::vector<double> bezier_knots(int degree, std::size_t count) {
  std::vector<double> knots(1, 0.0);
  for (std::size_t k = 0; k <= count; ++k)
    knots.insert(knots.end(), static_cast<std::size_t>(degree), static_cast<double>(k));
  knots.push_back(static_cast<double>(count));
  return knots;
}

void require_finite(const std::string& what, Point p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y))
    throw InputError(what + ": found the point " + describe(p) + "; expected finite coordinates");
}

void require_radius(const std::string& what, double radius) {
  if (!std::isfinite(radius) || radius <= 0)
    throw InputError(what + ": found radius " + describe(radius) +
                     "; expected a positive finite length");
}

void require_vertices(const std::string& what, std::span<const Point> vertices) {
  if (vertices.size() < 2)
    throw InputError(what + ": found " + std::to_string(vertices.size()) +
                     " vertices; expected at least two");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    require_finite(what, vertices[i]);
    if (i > 0 && vertices[i] == vertices[i - 1])
      throw InputError(what + ": vertices " + std::to_string(i) + " and " + std::to_string(i + 1) +
                       " both lie at " + describe(vertices[i]) +
                       "; expected neighbours that differ: remove one of them");
  }
}

Vector unit(Vector v) { return (1 / norm(v)) * v; }

/// Tangent at b of the circle through a, b, c; towards c where the three run back on themselves.
Vector circle_tangent(Point a, Point b, Point c) {
  const Vector before = b - a, after = c - b;
  const double ratio = norm(after) / norm(before);
  const Vector tangent = ratio * before + (1 / ratio) * after;
  return norm(tangent) > 1e-8 * (norm(before) + norm(after)) ? unit(tangent) : unit(after);
}

/// Tangent at the other end of the chord of the circle that has `tangent` at one end.
Vector mirrored(Vector tangent, Vector chord) {
  const Vector u = unit(chord);
  return 2 * dot(u, tangent) * u - tangent;
}

std::vector<Vector> spline_tangents(std::span<const Point> v, bool periodic) {
  const std::size_t last = v.size() - 1;
  std::vector<Vector> tangents(v.size());
  for (std::size_t i = 1; i < last; ++i) tangents[i] = circle_tangent(v[i - 1], v[i], v[i + 1]);
  if (periodic) {
    tangents[0] = tangents[last] = circle_tangent(v[last - 1], v[0], v[1]);
  } else if (last == 1) {
    tangents[0] = tangents[1] = unit(v[1] - v[0]);
  } else {
    tangents[0] = mirrored(tangents[1], v[1] - v[0]);
    tangents[last] = mirrored(tangents[last - 1], v[last] - v[last - 1]);
  }
  return tangents;
}

/// Length of the Bezier handle that follows a circular arc over `chord` to sixth order: with phi
/// between tangent and chord, (4/3) tan(phi/2) R = (2/3) |chord| / (1 + cos phi).
double handle_length(Vector chord, Vector tangent) {
  const double length = norm(chord);
  const double cosine = dot(chord, tangent) / length;
  return (2.0 / 3.0) * length / (1 + std::max(cosine, 0.0));
}

}  // namespace

NurbsCurve make_line(Point a, Point b) { return make_polyline(std::array{a, b}); }

NurbsCurve make_polyline(std::span<const Point> vertices) {
  require_vertices(vertices.size() == 2 ? "line" : "polyline", vertices);
  return {1, bezier_knots(1, vertices.size() - 1), std::vector<double>(vertices.size(), 1.0),
          std::vector<Point>(vertices.begin(), vertices.end())};
}

NurbsCurve make_arc(Point centre, double radius, double start_angle, double end_angle) {
  require_finite("arc", centre);
  require_radius("arc", radius);
  const double sweep = end_angle - start_angle;
  if (!std::isfinite(sweep) || sweep == 0 || std::fabs(sweep) > 2 * kPi * (1 + 1e-12))
    throw InputError("arc round " + describe(centre) + ": found the angles " +
                     describe(start_angle) + " and " + describe(end_angle) +
                     "; expected two angles in radians that differ by at most a full turn");
  const double quarters = std::ceil(std::fabs(sweep) / (0.5 * kPi) - 1e-12);
  const auto count = static_cast<std::size_t>(std::max(quarters, 1.0));
  const double half = 0.5 * sweep / static_cast<double>(count);
  NurbsCurve arc{2, bezier_knots(2, count), {}, {}};
  // The NURBS Book, section 7.3: the middle control point lies where the end tangents meet.
  for (std::size_t k = 0; k <= 2 * count; ++k) {
    const double angle = start_angle + static_cast<double>(k) * half;
    const double weight = k % 2 == 0 ? 1 : std::cos(half);
    arc.weights.push_back(weight);
    arc.points.push_back(centre + radius / weight * Vector{std::cos(angle), std::sin(angle)});
  }
  if (std::fabs(sweep) >= 2 * kPi * (1 - 1e-12)) arc.points.back() = arc.points.front();
  return arc;
}

NurbsCurve make_circle(Point centre, double radius) {
  require_radius("circle", radius);
  return make_ellipse(centre, radius, radius);
}

NurbsCurve make_ellipse(Point centre, double radius1, double radius2, double rotation) {
  require_finite("ellipse", centre);
  require_radius("ellipse", radius1);
  require_radius("ellipse", radius2);
  if (!std::isfinite(rotation))
    throw InputError("ellipse: found rotation " + describe(rotation) + "; expected a finite angle");
  // The unit circle in four quarters, mapped affinely (NURBS are affinely invariant).
  constexpr std::array<Point, 9> kCircle{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}};
  const Vector axis{std::cos(rotation), std::sin(rotation)}, normal{-axis.y, axis.x};
  NurbsCurve ellipse{2, bezier_knots(2, 4), {}, {}};
  for (std::size_t k = 0; k < kCircle.size(); ++k) {
    ellipse.weights.push_back(k % 2 == 0 ? 1 : std::sqrt(0.5));
    ellipse.points.push_back(centre + radius1 * kCircle[k].x * axis +
                             radius2 * kCircle[k].y * normal);
  }
  return ellipse;
}

NurbsCurve make_spline(std::span<const Point> vertices, SplineSeam seam) {
  require_vertices("spline", vertices);
  const bool periodic = seam == SplineSeam::smooth && vertices.front() == vertices.back();
  const std::vector<Vector> tangents = spline_tangents(vertices, periodic);
  NurbsCurve spline{3, bezier_knots(3, vertices.size() - 1), {}, {vertices.front()}};
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const Vector chord = vertices[i] - vertices[i - 1];
    spline.points.push_back(vertices[i - 1] +
                            handle_length(chord, tangents[i - 1]) * tangents[i - 1]);
    spline.points.push_back(vertices[i] - handle_length(chord, tangents[i]) * tangents[i]);
    spline.points.push_back(vertices[i]);
  }
  spline.weights.assign(spline.points.size(), 1.0);
  return spline;
}

}  // namespace anisofront
