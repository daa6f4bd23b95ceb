#pragma once

#include <cmath>
#include <vector>

#include "mesher/geometry/point.hpp"

namespace anisofront {

/// Order of the points along a Morton (Z) curve through the box: neighbours in space become
/// neighbours in memory. order[i] is the old index of the new i-th point.
std::vector<Index> spatial_order(const std::vector<Point>& points, Point low, Point high);

/// inverse[order[i]] == i.
std::vector<Index> inverse_permutation(const std::vector<Index>& order);

/// True when the vertices of a triangle lie far apart in memory on average, so that renumbering
/// pays. vertex_of(t, k): vertex k of triangle t.
template <class VertexOf>
bool is_scattered(std::size_t triangles, std::size_t vertices, VertexOf&& vertex_of) {
  if (vertices < 20000) return false;  // fits into the caches
  double spread = 0;
  std::size_t samples = 0;
  for (std::size_t t = 0; t < triangles; t += 16, ++samples)
    spread += std::abs(vertex_of(t, 0) - vertex_of(t, 1));
  return spread / static_cast<double>(samples) > 0.05 * static_cast<double>(vertices);
}

}  // namespace anisofront
