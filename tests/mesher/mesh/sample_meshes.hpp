#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "mesher/mesh/mesh.hpp"

namespace anisofront::samples {

/// The square [0, 2]^2 as 2 x 2 squares with both diagonals each (as initial/ex12.msh): vertices
/// 0..8 row by row, then the four centres. No edges.
inline Mesh crossed_square() {
  Mesh mesh;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) mesh.points.push_back({1.0 * i, 1.0 * j});
  for (const Index corner : {0, 1, 3, 4}) {
    const std::array<Index, 4> square{corner, corner + 1, corner + 4, corner + 3};
    const auto centre = static_cast<Index>(mesh.points.size());
    mesh.points.push_back(mesh.points[static_cast<std::size_t>(corner)] + Vector{0.5, 0.5});
    for (std::size_t k = 0; k < 4; ++k)
      mesh.triangles.push_back({square[k], square[(k + 1) % 4], centre});
  }
  mesh.triangle_regions.assign(mesh.triangles.size(), 7);
  return mesh;
}

/// A fan of `count` triangles round the origin.
inline Mesh disc(int count) {
  Mesh mesh;
  for (int i = 0; i < count; ++i)
    mesh.points.push_back(
        {std::cos(2 * std::numbers::pi * i / count), std::sin(2 * std::numbers::pi * i / count)});
  mesh.points.push_back({0, 0});
  for (int i = 0; i < count; ++i) mesh.triangles.push_back({i, (i + 1) % count, count});
  mesh.triangle_regions.assign(mesh.triangles.size(), 1);
  return mesh;
}

/// A ring of quads round the origin: inner vertices 0..count-1 (radius 1), outer ones count..
/// (radius 2).
inline Mesh ring(int count) {
  Mesh mesh;
  for (const double radius : {1.0, 2.0})
    for (int i = 0; i < count; ++i)
      mesh.points.push_back(radius * Point{std::cos(2 * std::numbers::pi * i / count),
                                           std::sin(2 * std::numbers::pi * i / count)});
  for (int i = 0; i < count; ++i) {
    const Index next = (i + 1) % count;
    mesh.quads.push_back({i, count + i, count + next, next});
  }
  mesh.quad_regions.assign(mesh.quads.size(), 3);
  return mesh;
}

}  // namespace anisofront::samples
