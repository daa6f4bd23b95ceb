#include "mesher/enhance/split.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/enhance/swap.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/geometry/predicates.hpp"

namespace anisofront {
namespace {

/// Fraction of ab at half its length when the size varies geometrically: with the ratio r of the
/// lengths in the two end metrics, ln((1 + r) / 2) / ln r, as a quotient of the series of both
/// logarithms in x = (r - 1) / (r + 1): no libm, so the same everywhere.
double midpoint_fraction(const WorkVertex& a, const WorkVertex& b) {
  const Vector u = b.p - a.p;
  const double la = length(a.r, u), lb = length(b.r, u);
  const double x = std::clamp((lb - la) / (lb + la), -0.6, 0.6);
  const double x2 = x * x;
  return (1 + x / 2 + x2 / 3 + x2 * x / 4 + x2 * x2 / 5) / (2 * (1 + x2 / 3 + x2 * x2 / 5));
}

Index add_vertex(Patch& patch, const WorkVertex& v, Index triangle) {
  patch.mesh.vertices.push_back(v);
  patch.triangle_of.push_back(triangle);
  patch.fixed.push_back(0);
  patch.active.push_back(1);
  return static_cast<Index>(patch.mesh.vertices.size()) - 1;
}

Index add_triangle(Patch& patch) {
  patch.mesh.triangles.emplace_back();
  patch.alpha.push_back(0);
  return static_cast<Index>(patch.mesh.triangles.size()) - 1;
}

/// Refreshes what the patch knows about new or changed triangles and swaps around them.
template <std::size_t n>
void finish(Patch& patch, Index vertex, const std::array<Index, n>& triangles) {
  for (const Index t : triangles) {
    for (const Index v : patch.mesh.triangles[t].vertices) patch.triangle_of[v] = t;
    patch.update_alpha(t);
    patch.activate(t);
  }
  for (const Index t : triangles)
    try_swap(patch, t, local_index(patch.mesh.triangles[t], vertex), SwapCriterion::minimum);
}

/// Splits the edge opposite vertex k of t (interior) by the new vertex v.
void split_edge(Patch& patch, Index t, int k, const WorkVertex& at) {
  const Index u = patch.mesh.triangles[t].neighbours[k];
  const Index t2 = add_triangle(patch), u2 = add_triangle(patch);
  const Index v = add_vertex(patch, at, t);
  const WorkTriangle left = patch.mesh.triangles[t], right = patch.mesh.triangles[u];
  const int j = side_towards(right, t);
  const Index c = left.vertices[k], a = left.vertices[kNext[k]], b = left.vertices[kPrevious[k]];
  const Index d = right.vertices[j];
  const Index across_bc = left.neighbours[kNext[k]], across_ca = left.neighbours[kPrevious[k]];
  const Index across_ad = right.neighbours[kNext[j]], across_db = right.neighbours[kPrevious[j]];
  patch.mesh.triangles[t] = {{c, a, v}, {u, t2, across_ca}};
  patch.mesh.triangles[t2] = {{c, v, b}, {u2, across_bc, t}};
  patch.mesh.triangles[u] = {{d, v, a}, {t, across_ad, u2}};
  patch.mesh.triangles[u2] = {{d, b, v}, {t2, u, across_db}};
  replace_neighbour(patch.mesh, across_bc, t, t2);
  replace_neighbour(patch.mesh, across_db, u, u2);
  finish(patch, v, std::array{t, t2, u, u2});
}

/// Splits triangle t into three around the new vertex.
void split_triangle(Patch& patch, Index t, const WorkVertex& at) {
  const Index t2 = add_triangle(patch), t3 = add_triangle(patch);
  const Index v = add_vertex(patch, at, t);
  const WorkTriangle old = patch.mesh.triangles[t];
  const auto [a, b, c] = old.vertices;
  const auto [across_bc, across_ca, across_ab] = old.neighbours;
  patch.mesh.triangles[t] = {{a, b, v}, {t2, t3, across_ab}};
  patch.mesh.triangles[t2] = {{b, c, v}, {t3, t, across_bc}};
  patch.mesh.triangles[t3] = {{c, a, v}, {t, t2, across_ca}};
  replace_neighbour(patch.mesh, across_bc, t, t2);
  replace_neighbour(patch.mesh, across_ca, t, t3);
  finish(patch, v, std::array{t, t2, t3});
}

/// Triangle with the directed edge ab, and the position of the vertex opposite; kNoIndex if none.
/// `near`: a triangle that held the edge once.
std::pair<Index, int> find_edge(const Patch& patch, Index a, Index b, Index near) {
  if (patch.triangle_of[a] == kNoIndex || patch.triangle_of[b] == kNoIndex) return {kNoIndex, 0};
  const auto& v = patch.mesh.triangles[near].vertices;
  const Index centre = patch.fixed[a] ? b : a;
  const bool holds = v[0] == centre || v[1] == centre || v[2] == centre;
  Ring ring;
  if (!fan_through(patch, centre, holds ? near : patch.triangle_of[centre], ring))
    return {kNoIndex, 0};
  for (int i = 0; i < ring.size; ++i) {
    const WorkTriangle& t = patch.mesh.triangles[ring.triangles[i]];
    for (int k = 0; k < 3; ++k)
      if (t.vertices[kNext[k]] == a && t.vertices[kPrevious[k]] == b) return {ring.triangles[i], k};
  }
  return {kNoIndex, 0};
}

WorkVertex midpoint(const Patch& patch, Index a, Index b) {
  const WorkVertex &va = patch.vertex(a), &vb = patch.vertex(b);
  WorkVertex middle{lerp(va.p, vb.p, midpoint_fraction(va, vb)), {}, va.hint};
  middle.r = patch.background.factor_at(middle.p, middle.hint);
  return middle;
}

/// The vertices opposite the edge k of t, in t and in its neighbour.
std::pair<Index, Index> opposite_vertices(const Patch& patch, Index t, int k) {
  const WorkTriangle& left = patch.mesh.triangles[t];
  const WorkTriangle& right = patch.mesh.triangles[left.neighbours[k]];
  return {left.vertices[k], right.vertices[side_towards(right, t)]};
}

bool split_if_valid(Patch& patch, Index t, int k, const WorkVertex& middle) {
  const auto [c, d] = opposite_vertices(patch, t, k);
  const WorkTriangle& left = patch.mesh.triangles[t];
  const Point a = patch.point(left.vertices[kNext[k]]),
              b = patch.point(left.vertices[kPrevious[k]]);
  const Point p = middle.p, pc = patch.point(c), pd = patch.point(d);
  if (orientation(a, p, pc) <= 0 || orientation(p, b, pc) <= 0 || orientation(p, a, pd) <= 0 ||
      orientation(b, p, pd) <= 0)
    return false;
  split_edge(patch, t, k, middle);
  ++patch.statistics.splits;
  return true;
}

}  // namespace

bool split(Patch& patch, Index a, Index b, double length, Index near) {
  const auto [t, k] = find_edge(patch, a, b, near);
  if (t == kNoIndex || patch.mesh.triangles[t].neighbours[k] < 0) return false;
  const WorkVertex middle = midpoint(patch, a, b);
  const auto [c, d] = opposite_vertices(patch, t, k);
  const double shortest = std::min(
      {edge_length(middle, patch.vertex(c)), edge_length(middle, patch.vertex(d)), 0.5 * length});
  if (shortest * length < 1) return false;
  return split_if_valid(patch, t, k, middle);
}

bool force_split(Patch& patch, Index triangle, int k) {
  const WorkTriangle& t = patch.mesh.triangles[triangle];
  if (t.neighbours[k] < 0) return false;
  const WorkVertex middle = midpoint(patch, t.vertices[kNext[k]], t.vertices[kPrevious[k]]);
  return split_if_valid(patch, triangle, k, middle);
}

Index insert_vertex(Patch& patch, Index triangle, Point p) {
  const WorkTriangle t = patch.mesh.triangles[triangle];
  for (const Index v : t.vertices)
    if (patch.point(v) == p) return v;
  WorkVertex at{p, {}, patch.vertex(t.vertices[0]).hint};
  at.r = patch.background.factor_at(p, at.hint);
  const auto v = static_cast<Index>(patch.mesh.vertices.size());
  for (int k = 0; k < 3; ++k) {
    const Point a = patch.point(t.vertices[kNext[k]]), b = patch.point(t.vertices[kPrevious[k]]);
    if (orientation(a, b, p) != 0) continue;
    if (t.neighbours[k] < 0)
      throw MeshingError("the required point (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
                         ") lies on a boundary edge; make it an end point of a curve");
    split_edge(patch, triangle, k, at);
    return v;
  }
  split_triangle(patch, triangle, at);
  return v;
}

}  // namespace anisofront
