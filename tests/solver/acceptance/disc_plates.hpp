#pragma once

#include <cmath>
#include <numbers>

#include "mesher/geometry/domain.hpp"
#include "mesher/mesh/boundary_domain.hpp"
#include "tests/solver/acceptance/solved_plate.hpp"

namespace anisofront::acceptance {

/// Tag of the edge of the disc.
inline constexpr Index kEdge = 11;

/// The unit disc, bounded by one circle.
inline Domain unit_disc() {
  Domain domain;
  domain.curves.push_back({"edge", kEdge, make_circle({0, 0}, 1)});
  add_region(domain, "disc", 1, {0}, {});
  return domain;
}

/// Quadrilaterals on the unit disc: n x n of a square in the middle and four blocks of n x rings
/// between its sides and the circle. 4 n vertices lie on the circle; the centre is a vertex.
/// Precondition: n even.
inline Mesh disc_of_quads(Index n, Index rings) {
  constexpr double kHalfSide = 0.4;
  Mesh mesh;
  const auto along = [n](Index i) { return 2. * i / n - 1; };
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i)
      mesh.points.push_back({kHalfSide * along(i), kHalfSide * along(j)});
  const auto core = [n](Index i, Index j) { return j * (n + 1) + i; };
  // Vertex k of ring r, anticlockwise from the lower right corner; ring 0 is the square's boundary.
  const auto vertex = [&](Index r, Index k) {
    const Index side = k / n % 4, i = k % n;
    if (r > 0) return (n + 1) * (n + 1) + (r - 1) * 4 * n + k % (4 * n);
    return side == 0   ? core(n, i)
           : side == 1 ? core(n - i, n)
           : side == 2 ? core(0, n - i)
                       : core(i, 0);
  };
  for (Index r = 1; r <= rings; ++r)
    for (Index k = 0; k < 4 * n; ++k) {
      const double angle = std::numbers::pi * (2. * k / (4 * n) - 0.25);
      mesh.points.push_back(lerp(mesh.points[vertex(0, k)], {std::cos(angle), std::sin(angle)},
                                 static_cast<double>(r) / rings));
    }
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      mesh.quads.push_back({core(i, j), core(i + 1, j), core(i + 1, j + 1), core(i, j + 1)});
  for (Index r = 0; r < rings; ++r)
    for (Index k = 0; k < 4 * n; ++k)
      mesh.quads.push_back(
          {vertex(r, k), vertex(r + 1, k), vertex(r + 1, k + 1), vertex(r, k + 1)});
  mesh.quad_regions.assign(mesh.quads.size(), 1);
  for (Index k = 0; k < 4 * n; ++k)
    mesh.edges.push_back({{vertex(rings, k), vertex(rings, k + 1)}, kEdge, 0, {}});
  mesh.groups = {{1, kEdge, "edge"}, {2, 1, "disc"}};
  attach_to_domain(mesh, unit_disc());
  return mesh;
}

/// disc_of_quads() with each quadrilateral cut in two.
inline Mesh disc_of_triangles(Index n, Index rings) {
  Mesh mesh = disc_of_quads(n, rings);
  for (const auto& [a, b, c, d] : mesh.quads) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  mesh.triangle_regions.assign(mesh.triangles.size(), 1);
  mesh.quads.clear();
  mesh.quad_regions.clear();
  return mesh;
}

}  // namespace anisofront::acceptance
