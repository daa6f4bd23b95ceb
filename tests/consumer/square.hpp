#pragma once

#include "mesher/geometry/domain.hpp"
#include "mesher/mesh/boundary_domain.hpp"
#include "mesher/mesh/mesh.hpp"

/// The unit square: its sides have the tags 1 to 4 from the bottom on.
inline anisofront::Domain unit_square() {
  using namespace anisofront;
  const Point corners[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const char* const names[4] = {"bottom", "right", "top", "left"};
  Domain domain;
  for (int k = 0; k < 4; ++k)
    domain.curves.push_back({names[k], k + 1, make_line(corners[k], corners[(k + 1) % 4])});
  add_region(domain, "square", 5, {0, 1, 2, 3}, {});
  return domain;
}

/// Two triangles, enough to carry a first metric.
inline anisofront::Mesh two_triangles() {
  anisofront::Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangle_regions = {5, 5};
  for (anisofront::Index k = 0; k < 4; ++k)
    mesh.edges.push_back({{k, (k + 1) % 4}, k + 1, k, {0, 1}});
  return mesh;
}
