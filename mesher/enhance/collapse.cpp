#include "mesher/enhance/collapse.hpp"

#include <algorithm>

#include "mesher/geometry/predicates.hpp"

namespace anisofront {
namespace {

int position_of(const Ring& ring, Index v) {
  for (int i = 0; i < ring.size; ++i)
    if (ring.vertices[i] == v) return i;
  return -1;
}

/// Link condition: a and b have exactly the two neighbours of their common edge in common.
bool two_common_neighbours(const Patch& patch, const Ring& ring, int at_b, Index b) {
  Ring other;
  if (!fan_through(patch, b, ring.triangles[at_b], other)) return false;
  int common = 0;
  for (int i = 0; i < ring.size; ++i)
    for (int j = 0; j < other.vertex_count(); ++j)
      if (ring.vertices[i] == other.vertices[j]) ++common;
  return common == 2;
}

bool result_is_good(const Patch& patch, const Ring& ring, Index b, double longest,
                    double least_alpha) {
  double worst = least_alpha;
  for (int i = 0; i < ring.size; ++i)
    worst = std::min(worst, static_cast<double>(patch.alpha[ring.triangles[i]]));
  for (int i = 0; i < ring.size; ++i) {
    const Index x = ring.vertices[i], y = ring.vertices[i + 1];
    if (x != b && edge_length(patch.vertex(b), patch.vertex(x)) > longest) return false;
    if (x == b || y == b) continue;
    const double alpha = patch.alpha_of(b, x, y);
    if (alpha <= 0 || alpha < worst) return false;
    if (orientation(patch.point(b), patch.point(x), patch.point(y)) <= 0) return false;
  }
  return true;
}

/// Removes a triangle that holds the edge ab: what lies across its two other sides becomes
/// neighbours.
void remove_triangle(Patch& patch, Index t, Index a, Index b) {
  WorkTriangle& triangle = patch.mesh.triangles[t];
  const int ia = local_index(triangle, a), ib = local_index(triangle, b);
  const Index third = triangle.vertices[3 - ia - ib];
  const Index across_a = triangle.neighbours[ia], across_b = triangle.neighbours[ib];
  replace_neighbour(patch.mesh, across_a, t, across_b);
  replace_neighbour(patch.mesh, across_b, t, across_a);
  patch.triangle_of[third] = across_b >= 0 ? across_b : across_a;
  triangle = WorkTriangle{};
}

}  // namespace

bool collapse(Patch& patch, Index a, Index b, double longest, double least_alpha) {
  if (patch.fixed[a] || patch.triangle_of[a] == kNoIndex || patch.triangle_of[b] == kNoIndex)
    return false;
  Ring ring;
  if (!closed_ring(patch, a, ring) || ring.size <= 3) return false;
  const int at_b = position_of(ring, b);
  if (at_b < 0 || !two_common_neighbours(patch, ring, at_b, b) ||
      !result_is_good(patch, ring, b, longest, least_alpha))
    return false;
  for (int i = 0; i < ring.size; ++i)
    if (ring.vertices[i] == b || ring.vertices[i + 1] == b)
      remove_triangle(patch, ring.triangles[i], a, b);
  for (int i = 0; i < ring.size; ++i) {
    WorkTriangle& triangle = patch.mesh.triangles[ring.triangles[i]];
    if (triangle.dead()) continue;
    triangle.vertices[local_index(triangle, a)] = b;
    for (const Index v : triangle.vertices) patch.triangle_of[v] = ring.triangles[i];
    patch.update_alpha(ring.triangles[i]);
    patch.activate(ring.triangles[i]);
  }
  patch.triangle_of[a] = kNoIndex;
  ++patch.statistics.collapses;
  return true;
}

}  // namespace anisofront
