#include "mesher/enhance/required_points.hpp"

#include <algorithm>
#include <string>

#include "mesher/background/alternating_digital_tree.hpp"
#include "mesher/enhance/split.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/geometry/predicates.hpp"

namespace anisofront {
namespace {

Box box_of(const Patch& patch, const WorkTriangle& t) {
  const Point a = patch.point(t.vertices[0]), b = patch.point(t.vertices[1]),
              c = patch.point(t.vertices[2]);
  return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
          {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
}

bool contains(const Patch& patch, Index triangle, Point p) {
  const auto& v = patch.mesh.triangles[triangle].vertices;
  for (int k = 0; k < 3; ++k)
    if (orientation(patch.point(v[k]), patch.point(v[kNext[k]]), p) < 0) return false;
  return true;
}

AlternatingDigitalTree triangle_tree(const Patch& patch) {
  Box bounds{patch.point(0), patch.point(0)};
  for (const WorkVertex& v : patch.mesh.vertices) bounds = enclosing(bounds, v.p);
  AlternatingDigitalTree tree(bounds);
  tree.reserve(patch.mesh.triangles.size());
  for (const WorkTriangle& t : patch.mesh.triangles) tree.insert(box_of(patch, t));
  return tree;
}

/// Breadth-first from the triangles that the tree knows: insertions before this one have changed
/// the mesh, but only near there.
Index locate(const Patch& patch, std::vector<Index> queue, Point p) {
  std::sort(queue.begin(), queue.end());
  std::vector<char> seen(patch.mesh.triangles.size(), 0);
  for (const Index t : queue) seen[t] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index t = queue[i];
    if (contains(patch, t, p)) return t;
    for (const Index n : patch.mesh.triangles[t].neighbours) {
      if (n < 0 || seen[n]) continue;
      seen[n] = 1;
      queue.push_back(n);
    }
  }
  return kNoIndex;
}

}  // namespace

std::vector<Index> insert_required_points(Patch& patch, const std::vector<Point>& points) {
  std::vector<Index> vertices;
  if (points.empty()) return vertices;
  const AlternatingDigitalTree tree = triangle_tree(patch);
  for (const Point p : points) {
    std::vector<Index> start;
    Index found = kNoIndex;
    tree.query({p, p}, [&](Index t) {
      start.push_back(t);
      if (contains(patch, t, p) && (found == kNoIndex || t < found)) found = t;
    });
    if (found == kNoIndex) found = locate(patch, start, p);
    if (found == kNoIndex)
      throw MeshingError("the required point (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
                         ") lies outside the meshed domain");
    const Index v = insert_vertex(patch, found, p);
    patch.fixed[v] = 1;
    vertices.push_back(v);
  }
  return vertices;
}

void insert_inner_points(const Domain& domain, Patch& patch, std::vector<Index>& point_vertices) {
  std::vector<Point> inner;
  for (std::size_t i = 0; i < point_vertices.size(); ++i)
    if (point_vertices[i] == kNoIndex) inner.push_back(domain.points[i].point);
  const std::vector<Index> inserted = insert_required_points(patch, inner);
  std::size_t next = 0;
  for (Index& v : point_vertices)
    if (v == kNoIndex) v = inserted[next++];
}

}  // namespace anisofront
