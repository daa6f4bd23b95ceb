#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "mesher/mesh/mesh.hpp"

namespace anisofront::test {

/// Tags of the sides of square_mesh().
inline constexpr Index kBottom = 1, kRight = 2, kTop = 3, kLeft = 4;

/// Unit square cut into nx x ny rectangles, those that `is_cut(i, j)` chooses into two triangles.
/// Vertex j (nx + 1) + i lies in column i and row j.
inline Mesh square_of(Index nx, Index ny, const std::function<bool(Index, Index)>& is_cut) {
  Mesh mesh;
  const auto vertex = [nx](Index i, Index j) { return j * (nx + 1) + i; };
  for (Index j = 0; j <= ny; ++j)
    for (Index i = 0; i <= nx; ++i)
      mesh.points.push_back({static_cast<double>(i) / nx, static_cast<double>(j) / ny});
  for (Index j = 0; j < ny; ++j)
    for (Index i = 0; i < nx; ++i) {
      const Index a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                  d = vertex(i, j + 1);
      if (is_cut(i, j)) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      } else {
        mesh.quads.push_back({a, b, c, d});
      }
    }
  mesh.triangle_regions.assign(mesh.triangles.size(), 1);
  mesh.quad_regions.assign(mesh.quads.size(), 1);
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

/// Unit square cut into nx x ny rectangles, each into two triangles.
inline Mesh square_mesh(Index nx, Index ny) {
  return square_of(nx, ny, [](Index, Index) { return true; });
}
inline Mesh square_mesh(Index n) { return square_mesh(n, n); }

/// Unit square cut into nx x ny rectangles.
inline Mesh square_quads(Index nx, Index ny) {
  return square_of(nx, ny, [](Index, Index) { return false; });
}

/// Unit square cut into nx x ny rectangles, every second of them (as on a chess board) into two
/// triangles.
inline Mesh mixed_square(Index nx, Index ny) {
  return square_of(nx, ny, [](Index i, Index j) { return (i + j) % 2 == 0; });
}

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

/// A mesh of the unit square in nx x ny cells with interior vertices moved by up to `share` of the
/// spacing in each direction: cells of aspect ny / nx keep it. Needs share < 0.5; quadrilaterals
/// stay convex up to 0.3.
inline Mesh perturbed(Mesh mesh, Index nx, Index ny, double share, std::uint64_t seed) {
  Noise noise(seed);
  return mapped(std::move(mesh), [&](Point p) {
    const bool inside = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1;
    const Vector shift{share / nx * noise(), share / ny * noise()};
    return inside ? p + shift : p;
  });
}

/// Each triangle cut into three quadrilaterals by its centroid and the midpoints of its edges: the
/// quadrilaterals that the paper's conversion makes of triangles. Curve edges are halved.
/// Precondition: triangles only.
inline Mesh three_quads_of(const Mesh& mesh) {
  Mesh result;
  result.points = mesh.points;
  result.groups = mesh.groups;
  std::map<std::array<Index, 2>, Index> middle;
  const auto middle_of = [&](Index a, Index b) {
    const auto [it, is_new] = middle.try_emplace({std::min(a, b), std::max(a, b)},
                                                 static_cast<Index>(result.points.size()));
    if (is_new) result.points.push_back(lerp(mesh.points[a], mesh.points[b], 0.5));
    return it->second;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const Index ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
    const auto centre = static_cast<Index>(result.points.size());
    result.points.push_back((1. / 3) * (mesh.points[a] + mesh.points[b] + mesh.points[c]));
    for (const Quad& quad : {Quad{a, ab, centre, ca}, {b, bc, centre, ab}, {c, ca, centre, bc}}) {
      result.quads.push_back(quad);
      result.quad_regions.push_back(mesh.triangle_regions[t]);
    }
  }
  for (CurveEdge edge : mesh.edges) {
    const auto [a, b] = edge.vertices;
    const auto [s, t] = edge.parameters;
    const Index m = middle_of(a, b);
    edge.vertices = {a, m};
    edge.parameters = {s, (s + t) / 2};
    result.edges.push_back(edge);
    edge.vertices = {m, b};
    edge.parameters = {(s + t) / 2, t};
    result.edges.push_back(edge);
  }
  return result;
}

// Gradings of [0, 1] onto itself for layers, to be used with mapped().

/// Shishkin: a quarter of the intervals in [0, width] and in [1 - width, 1] each.
inline double layers_at_both_ends(double s, double width) {
  if (s > 0.5) return 1 - layers_at_both_ends(1 - s, width);
  return s < 0.25 ? 4 * s * width : width + (4 * s - 1) * (0.5 - width);
}

/// Shishkin: half of the intervals in [1 - width, 1].
inline double layer_at_end(double s, double width) {
  return s < 0.5 ? 2 * s * (1 - width) : 1 - width + (2 * s - 1) * width;
}

/// Smooth and symmetric: intervals grow in proportion to about the distance from the ends; those at
/// the ends are strength / sinh(strength) times the average.
inline double sinh_grading(double s, double strength) {
  if (s > 0.5) return 1 - sinh_grading(1 - s, strength);
  return 0.5 * std::sinh(2 * strength * s) / std::sinh(strength);
}

}  // namespace anisofront::test
