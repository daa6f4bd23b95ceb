#pragma once

// Meshes in the making for the tests of front and enhance, and the check of their invariants.
#include <map>
#include <memory>
#include <string>

#include "mesher/enhance/patch.hpp"
#include "mesher/front/advance.hpp"
#include "mesher/front/boundary.hpp"
#include "mesher/geometry/predicates.hpp"
#include "tests/support/domains.hpp"
#include "tests/support/meshes.hpp"

namespace anisofront::testing {

/// A domain in the box [low, high] with a metric on a crossed grid, its boundary cut into segments.
struct WorkCase {
  std::unique_ptr<BackgroundMesh> background;
  Boundary boundary;

  WorkCase(const Domain& domain, const MetricFunction& metric, Point low, Point high,
           Index cells = 6) {
    const Mesh grid = crossed_rectangle(cells, cells, low, high);
    background = std::make_unique<BackgroundMesh>(grid, sample(grid, metric));
    boundary = discretise_boundary(domain, grid, *background, {}, 100000);
  }
  WorkMesh& mesh() { return boundary.mesh; }
  double expected() const { return 4 / std::sqrt(3.) * background->complexity(); }
  FrontStatistics advance(const FrontOptions& options = {}) {
    return advance_front(*background, mesh(), options, expected());
  }
};

inline double area_of(const WorkMesh& mesh) {
  double area = 0;
  for (const WorkTriangle& t : mesh.triangles)
    if (!t.dead())
      area += 0.5 * twice_area(mesh.vertices[t.vertices[0]].p, mesh.vertices[t.vertices[1]].p,
                               mesh.vertices[t.vertices[2]].p);
  return area;
}

inline Index live_triangles(const WorkMesh& mesh) {
  Index count = 0;
  for (const WorkTriangle& t : mesh.triangles) count += t.dead() ? 0 : 1;
  return count;
}

/// The first broken invariant, or an empty text: triangles positive (exact), every directed edge
/// once, neighbours mutual across the right edge, segments where the mesh says, and every segment
/// side with a region has a triangle.
inline std::string broken_invariant(const WorkMesh& mesh) {
  std::map<std::pair<Index, Index>, Index> owner;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    const auto& [v, n] = mesh.triangles[t];
    if (v[0] == kNoIndex) continue;
    const std::string name = "triangle " + std::to_string(t);
    if (orientation(mesh.vertices[v[0]].p, mesh.vertices[v[1]].p, mesh.vertices[v[2]].p) <= 0)
      return name + " is not positive";
    for (int k = 0; k < 3; ++k) {
      const Index a = v[kNext[k]], b = v[kPrevious[k]];
      if (!owner.insert({{a, b}, t}).second) return name + " shares a directed edge";
      if (n[k] < 0) {
        const Segment& s = mesh.segments[~n[k]];
        const Index region = s.a == a ? s.left_region : s.right_region;
        if (std::minmax(s.a, s.b) != std::minmax(a, b) || region == kNoIndex)
          return name + " has a wrong segment";
      } else {
        const WorkTriangle& u = mesh.triangles[n[k]];
        if (u.dead()) return name + " has a dead neighbour";
        const int j = side_towards(u, t);
        if (u.neighbours[j] != t || u.vertices[kNext[j]] != b || u.vertices[kPrevious[j]] != a)
          return name + " has a wrong neighbour";
      }
    }
  }
  for (const Segment& s : mesh.segments) {
    if (s.left_region != kNoIndex && !owner.count({s.a, s.b})) return "no triangle left of segment";
    if (s.right_region != kNoIndex && !owner.count({s.b, s.a}))
      return "no triangle right of segment";
  }
  return {};
}

inline std::string broken_invariant(const Patch& patch) {
  for (Index v = 0; v < static_cast<Index>(patch.mesh.vertices.size()); ++v) {
    const Index t = patch.triangle_of[v];
    if (t == kNoIndex) continue;
    const auto& w = patch.mesh.triangles[t].vertices;
    if (w[0] != v && w[1] != v && w[2] != v)
      return "triangle_of of vertex " + std::to_string(v) + " is stale";
  }
  if (patch.alpha.size() != patch.mesh.triangles.size()) return "number of alphas";
  return broken_invariant(patch.mesh);
}

}  // namespace anisofront::testing
