#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "mesher/mesh/mesh.hpp"

namespace anisofront::test {

/// Tags of the sides of square_mesh().
inline constexpr Index kBottom = 1, kRight = 2, kTop = 3, kLeft = 4;

/// Unit square cut into nx x ny rectangles, each into two triangles.
inline Mesh square_mesh(Index nx, Index ny) {
  Mesh mesh;
  const auto vertex = [nx](Index i, Index j) { return j * (nx + 1) + i; };
  for (Index j = 0; j <= ny; ++j)
    for (Index i = 0; i <= nx; ++i)
      mesh.points.push_back({static_cast<double>(i) / nx, static_cast<double>(j) / ny});
  for (Index j = 0; j < ny; ++j)
    for (Index i = 0; i < nx; ++i) {
      const Index a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                  d = vertex(i, j + 1);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  mesh.triangle_regions.assign(mesh.triangles.size(), 1);
  const auto add_edge = [&mesh](Index a, Index b, Index tag) {
    CurveEdge edge;
    edge.vertices = {a, b};
    edge.tag = tag;
    edge.curve = tag - 1;
    mesh.edges.push_back(edge);
  };
  for (Index i = 0; i < nx; ++i) add_edge(vertex(i, 0), vertex(i + 1, 0), kBottom);
  for (Index j = 0; j < ny; ++j) add_edge(vertex(nx, j), vertex(nx, j + 1), kRight);
  for (Index i = nx; i > 0; --i) add_edge(vertex(i, ny), vertex(i - 1, ny), kTop);
  for (Index j = ny; j > 0; --j) add_edge(vertex(0, j), vertex(0, j - 1), kLeft);
  return mesh;
}
inline Mesh square_mesh(Index n) { return square_mesh(n, n); }

/// The points moved by a map that must keep the triangles positive.
inline Mesh mapped(Mesh mesh, const std::function<Point(Point)>& map) {
  for (Point& p : mesh.points) p = map(p);
  return mesh;
}

/// Uniform numbers in [-1, 1] from a fixed linear congruential sequence (the same everywhere).
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : state_(seed) {}
  double operator()() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) * 0x1p-52 - 1;
  }

 private:
  std::uint64_t state_;
};

/// square_mesh(n) with interior vertices moved by up to `share` of the spacing.
inline Mesh perturbed_mesh(Index n, double share, std::uint64_t seed) {
  Noise noise(seed);
  return mapped(square_mesh(n), [&](Point p) {
    const bool inside = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1;
    const Vector shift{noise(), noise()};
    return inside ? p + (share / n) * shift : p;
  });
}

}  // namespace anisofront::test
