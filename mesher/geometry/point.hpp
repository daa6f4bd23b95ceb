#pragma once

#include <cmath>
#include <cstdint>

namespace anisofront {

/// Index of a vertex, edge or element. 32 bits: 2e9 entities are more than one machine meshes.
using Index = std::int32_t;

/// "No such entity": outside the mesh, no neighbour, not on a curve.
inline constexpr Index kNoIndex = -1;

/// A point or a vector of the plane, in the length unit of the model.
struct Point {
  double x = 0;
  double y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

using Vector = Point;

inline Vector operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Vector operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Vector operator-(Point a) { return {-a.x, -a.y}; }
inline Vector operator*(double s, Point a) { return {s * a.x, s * a.y}; }
inline Vector operator*(Point a, double s) { return {s * a.x, s * a.y}; }
inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
/// z-component of a x b: positive when b lies anticlockwise of a.
inline double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
inline double squared_norm(Vector a) { return dot(a, a); }
inline double norm(Vector a) { return std::sqrt(dot(a, a)); }
inline Point lerp(Point a, Point b, double t) { return a + t * (b - a); }
/// Twice the signed area of the triangle abc; rounded, see predicates.hpp for the exact sign.
inline double twice_area(Point a, Point b, Point c) { return cross(b - a, c - a); }

}  // namespace anisofront
