#pragma once

#include <array>
#include <span>

#include "mesher/geometry/point.hpp"

namespace anisofront {

/// A point of a triangle rule: barycentric coordinates (sum 1) and weight (share of the area).
struct QuadraturePoint {
  std::array<double, 3> barycentric{};
  double weight = 0;
};

/// Highest polynomial degree for which triangle_quadrature() has a rule.
inline constexpr int kMaxQuadratureDegree = 12;

/// Symmetric rule of least points that integrates polynomials up to `degree` exactly: weights are
/// positive and sum to 1, all points lie inside. The integral over a triangle is its area times
/// the weighted sum. The span refers to static tables.
/// Precondition: 0 <= degree <= kMaxQuadratureDegree; throws std::out_of_range otherwise.
std::span<const QuadraturePoint> triangle_quadrature(int degree);

/// The point of the triangle with these barycentric coordinates.
inline Point point_at(const std::array<Point, 3>& corners, const std::array<double, 3>& l) {
  return l[0] * corners[0] + l[1] * corners[1] + l[2] * corners[2];
}

}  // namespace anisofront
