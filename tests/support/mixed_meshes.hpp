#pragma once

// Meshes of triangles and quadrilaterals in the making, and their way to the check of finished
// meshes.
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "mesher/background/background_mesh.hpp"
#include "mesher/mesh/check.hpp"
#include "mesher/quads/mixed_mesh.hpp"
#include "tests/support/domains.hpp"
#include "tests/support/meshes.hpp"

namespace anisofront::testing {

inline MixedFace triangle(Index a, Index b, Index c) { return {{a, b, c, kNoIndex}}; }
inline MixedFace quad(Index a, Index b, Index c, Index d) { return {{a, b, c, d}}; }

/// Vertices without a metric at the points, none of them required.
inline MixedMesh mixed_mesh(const std::vector<Point>& points, std::vector<MixedFace> faces) {
  MixedMesh mesh;
  for (const Point p : points) mesh.vertices.push_back({p, {}, 0});
  mesh.faces = std::move(faces);
  mesh.required.assign(points.size(), 0);
  return mesh;
}

inline void look_up_metrics(const BackgroundMesh& background, MixedMesh& mesh) {
  for (WorkVertex& v : mesh.vertices) v.r = background.factor_at(v.p, v.hint);
}

/// A metric on the box.
inline std::unique_ptr<BackgroundMesh> background(const MetricFunction& metric, Point low,
                                                  Point high, Index cells = 8) {
  const Mesh grid = crossed_rectangle(cells, cells, low, high);
  return std::make_unique<BackgroundMesh>(grid, sample(grid, metric));
}

/// The n x n squares of [0, 1]^2 with the segments of square_domain(1); vertex j (n + 1) + i lies
/// in column i and row j.
inline MixedMesh square_grid(Index n) {
  std::vector<Point> points;
  std::vector<MixedFace> faces;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) points.push_back({1. * i / n, 1. * j / n});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      faces.push_back(quad(a, a + 1, a + n + 2, a + n + 1));
    }
  MixedMesh mesh = mixed_mesh(points, std::move(faces));
  const Index w = n + 1;
  const auto add = [&](Index a, Index b, Index curve, Index i) {
    mesh.segments.push_back({a, b, curve, 1. * i / n, 1. * (i + 1) / n, 0, kNoIndex});
  };
  for (Index i = 0; i < n; ++i) add(i, i + 1, 0, i);
  for (Index i = 0; i < n; ++i) add(i * w + n, (i + 1) * w + n, 1, i);
  for (Index i = 0; i < n; ++i) add(n * w + n - i, n * w + n - i - 1, 2, i);
  for (Index i = 0; i < n; ++i) add((n - i) * w, (n - i - 1) * w, 3, i);
  return mesh;
}

/// The same with some squares cut into two triangles and the inner vertices moved a little.
inline MixedMesh random_grid(std::mt19937_64& random, Index n, double move, double triangles) {
  std::uniform_real_distribution<double> unit(0, 1);
  MixedMesh mesh = square_grid(n);
  std::vector<MixedFace> faces;
  for (const MixedFace& face : mesh.faces) {
    const auto [a, b, c, d] = face.vertices;
    if (unit(random) >= triangles) {
      faces.push_back(face);
    } else if (unit(random) < 0.5) {
      faces.insert(faces.end(), {triangle(a, b, c), triangle(a, c, d)});
    } else {
      faces.insert(faces.end(), {triangle(a, b, d), triangle(b, c, d)});
    }
  }
  mesh.faces = std::move(faces);
  for (Index j = 1; j < n; ++j)
    for (Index i = 1; i < n; ++i) {
      Point& p = mesh.vertices[j * (n + 1) + i].p;
      const double dx = 2 * unit(random) - 1, dy = 2 * unit(random) - 1;
      p = p + (move / n) * Vector{dx, dy};
    }
  return mesh;
}

/// For check_mesh(): vertices without a face are left out, all faces lie in region 0.
inline Mesh to_mesh(const MixedMesh& mixed) {
  Mesh mesh;
  std::vector<Index> number(mixed.vertices.size(), kNoIndex);
  for (const MixedFace& face : mixed.faces)
    for (int k = 0; k < face.size(); ++k) number[face.vertices[k]] = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNoIndex) continue;
    number[v] = static_cast<Index>(mesh.points.size());
    mesh.points.push_back(mixed.vertices[v].p);
  }
  for (const MixedFace& face : mixed.faces) {
    const auto& v = face.vertices;
    if (face.is_quad())
      mesh.quads.push_back({number[v[0]], number[v[1]], number[v[2]], number[v[3]]});
    else
      mesh.triangles.push_back({number[v[0]], number[v[1]], number[v[2]]});
  }
  mesh.triangle_regions.assign(mesh.triangles.size(), 0);
  mesh.quad_regions.assign(mesh.quads.size(), 0);
  for (const Segment& s : mixed.segments)
    mesh.edges.push_back({{number[s.a], number[s.b]}, 1, s.curve, {s.parameter_a, s.parameter_b}});
  return mesh;
}

/// The first defect that check_mesh() finds, or an empty text.
inline std::string first_defect(const MixedMesh& mesh) {
  const MeshReport report = check_mesh(to_mesh(mesh));
  return report.valid() ? "" : report.defects.front();
}

}  // namespace anisofront::testing
