#pragma once

// Discs round the origin: their domain, and meshes that know their curve.
#include <numbers>

#include "mesher/geometry/domain.hpp"
#include "tests/solver/square_mesh.hpp"

namespace anisofront::test {

/// Tag of the circle.
inline constexpr Index kRim = 7;

inline Domain disc_domain(double radius = 1) {
  Domain domain;
  domain.curves.push_back({"rim", kRim, make_circle({0, 0}, radius)});
  add_region(domain, "disc", 1, {0}, {});
  return domain;
}

/// Moves the vertices of curve edges onto the circle and sets their parameters.
inline void attach_to_circle(Mesh& mesh, double radius = 1) {
  const NurbsCurve circle = make_circle({0, 0}, radius);
  for (CurveEdge& edge : mesh.edges) {
    for (int k = 0; k < 2; ++k) {
      Point& p = mesh.points[edge.vertices[k]];
      p = (radius / norm(p)) * p;
      edge.parameters[k] = nearest_point(circle, p).parameter;
    }
    if (edge.parameters[0] > 3.999) edge.parameters[0] = 0;
    if (edge.parameters[1] < edge.parameters[0]) edge.parameters[1] = 4;
  }
}

/// Triangles in n rings of 6, 12, ... vertices round the centre; the rim has tag kRim and group
/// "rim".
inline Mesh disc_mesh(Index n, double radius = 1) {
  Mesh mesh;
  mesh.points.push_back({0, 0});
  const auto vertex = [](Index ring, Index k) {
    return ring == 0 ? 0 : 3 * ring * (ring - 1) + 1 + k % (6 * ring);
  };
  for (Index ring = 1; ring <= n; ++ring)
    for (Index k = 0; k < 6 * ring; ++k) {
      const double angle = 2 * std::numbers::pi * k / (6 * ring), r = radius * ring / n;
      mesh.points.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
  for (Index ring = 1; ring <= n; ++ring)
    for (Index sector = 0; sector < 6; ++sector)
      for (Index k = 0; k < ring; ++k) {
        const Index outer = sector * ring + k, inner = sector * (ring - 1) + k;
        mesh.triangles.push_back(
            {vertex(ring, outer), vertex(ring, outer + 1), vertex(ring - 1, inner)});
        if (k > 0)
          mesh.triangles.push_back(
              {vertex(ring, outer), vertex(ring - 1, inner), vertex(ring - 1, inner - 1)});
      }
  mesh.triangle_regions.assign(mesh.triangles.size(), 1);
  for (Index k = 0; k < 6 * n; ++k)
    mesh.edges.push_back({{vertex(n, k), vertex(n, k + 1)}, kRim, 0, {}});
  mesh.groups = {{1, kRim, "rim"}, {2, 1, "disc"}};
  attach_to_circle(mesh, radius);
  return mesh;
}

/// disc_mesh(n) with each triangle cut into three quadrilaterals.
inline Mesh disc_quads(Index n) {
  Mesh mesh = three_quads_of(disc_mesh(n));
  attach_to_circle(mesh);
  return mesh;
}

}  // namespace anisofront::test
