#pragma once

#include <array>
#include <span>

#include "mesher/mesh/mesh.hpp"

namespace anisofront {

inline std::array<Point, 3> corners_of(const Mesh& mesh, const Triangle& triangle) {
  return {mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]]};
}

/// The linear triangle: area and the constant gradients of the barycentric coordinates.
struct P1Element {
  double area = 0;
  std::array<Vector, 3> gradients{};

  /// Precondition: anticlockwise corners, positive area.
  explicit P1Element(const std::array<Point, 3>& p) : area(0.5 * twice_area(p[0], p[1], p[2])) {
    const double scale = 0.5 / area;
    for (int i = 0; i < 3; ++i) {
      const Vector opposite = p[(i + 2) % 3] - p[(i + 1) % 3];
      gradients[i] = scale * Vector{-opposite.y, opposite.x};
    }
  }

  /// Gradient of the linear function with these values at the corners.
  Vector gradient(const std::array<double, 3>& values) const {
    return values[0] * gradients[0] + values[1] * gradients[1] + values[2] * gradients[2];
  }
};

inline std::array<double, 3> values_at(std::span<const double> vertex_values, const Triangle& t) {
  return {vertex_values[t[0]], vertex_values[t[1]], vertex_values[t[2]]};
}

}  // namespace anisofront
