#pragma once

// Quadrilateral meshes for the tests of the half-edge mesh and the check of its invariants.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "mesher/mesh/topology.hpp"
#include "mesher/quads/convexity.hpp"
#include "mesher/quads/quad_operations.hpp"
#include "tests/support/meshes.hpp"

namespace anisofront::testing {

/// n x m unit squares on [0, n] x [0, m] without those that `is_hole` names by their lower left
/// corner; vertex j (n + 1) + i lies at (i, j). No segments yet.
template <class IsHole>
MixedMesh quad_grid(Index n, Index m, IsHole&& is_hole) {
  MixedMesh mesh;
  for (Index j = 0; j <= m; ++j)
    for (Index i = 0; i <= n; ++i) mesh.vertices.push_back({{1. * i, 1. * j}, {}, 0});
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      if (!is_hole(i, j)) mesh.faces.push_back({{a, a + 1, a + n + 2, a + n + 1}});
    }
  mesh.required.assign(mesh.vertices.size(), 0);
  return mesh;
}

inline std::vector<Quad> quads_of(const MixedMesh& mesh) {
  std::vector<Quad> quads;
  for (const MixedFace& face : mesh.faces) quads.push_back(face.vertices);
  return quads;
}

/// A segment along every boundary edge, region 0 on its left.
inline void add_rim(MixedMesh& mesh) {
  Mesh plain;
  plain.points.resize(mesh.vertices.size());
  plain.quads = quads_of(mesh);
  for (const auto& [a, b] : boundary_edges(plain)) mesh.segments.push_back({a, b, 0, 0, 1, 0});
}

/// Segments along a path of vertices inside: region 0 on both sides.
inline void embed(MixedMesh& mesh, const std::vector<Index>& path) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    mesh.segments.push_back(
        {path[i], path[i + 1], 1, 1. * static_cast<double>(i), 1. + static_cast<double>(i), 0, 0});
}

inline MixedMesh plain_grid(Index n, Index m) {
  MixedMesh mesh = quad_grid(n, m, [](Index, Index) { return false; });
  add_rim(mesh);
  return mesh;
}

/// 6 x 6 squares without the upper right 3 x 3: the re-entrant corner is vertex 24.
inline MixedMesh l_shape() {
  MixedMesh mesh = quad_grid(6, 6, [](Index i, Index j) { return i >= 3 && j >= 3; });
  add_rim(mesh);
  return mesh;
}

/// 6 x 6 squares without the 2 x 2 in the middle.
inline MixedMesh annulus() {
  MixedMesh mesh = quad_grid(6, 6, [](Index i, Index j) { return i / 2 == 1 && j / 2 == 1; });
  add_rim(mesh);
  return mesh;
}

/// n x m squares with segments along a path of vertices.
inline MixedMesh grid_with_path(Index n, Index m, const std::vector<Index>& path) {
  MixedMesh mesh = plain_grid(n, m);
  embed(mesh, path);
  return mesh;
}

struct NamedMesh {
  std::string name;
  MixedMesh mesh;
};

/// 5 x 4 squares around a required vertex.
inline MixedMesh grid_with_required() {
  MixedMesh mesh = plain_grid(5, 4);
  mesh.required[14] = 1;
  return mesh;
}

/// Two interfaces that cross in vertex 24 of a 6 x 6 grid: four copies there.
inline MixedMesh crossing() {
  MixedMesh mesh = grid_with_path(6, 6, {21, 22, 23, 24, 25, 26, 27});
  embed(mesh, {3, 10, 17, 24, 31, 38, 45});
  return mesh;
}

/// A mesh for every kind of boundary and interface.
inline std::vector<NamedMesh> property_meshes() {
  return {{"grid", plain_grid(5, 4)},
          {"L", l_shape()},
          {"annulus", annulus()},
          {"interface", grid_with_path(6, 4, {3, 10, 17, 24, 31})},
          {"crossing", crossing()},
          {"crack", grid_with_path(6, 6, {3, 10, 17, 24})},
          {"embedded", grid_with_path(6, 6, {23, 24, 25})},
          {"one segment", grid_with_path(6, 6, {23, 24})},
          {"required", grid_with_required()}};
}

/// A background mesh with the metric on a crossed grid.
inline BackgroundMesh background_of(const MetricFunction& metric, Point low, Point high,
                                    Index cells = 8) {
  const Mesh grid = crossed_rectangle(cells, cells, low, high);
  return BackgroundMesh(grid, sample(grid, metric));
}

/// Metrics of the background at all vertices.
inline void fit(const BackgroundMesh& background, MixedMesh& mesh) {
  for (WorkVertex& v : mesh.vertices) v.r = background.factor_at(v.p, v.hint);
}

inline QuadWork work_on(const BackgroundMesh& background, MixedMesh mesh,
                        const QuadWeights& weights = {}) {
  fit(background, mesh);
  return QuadWork(background, make_quad_mesh(mesh), weights);
}

/// A mesh to work on under the unit metric.
struct UnitCase {
  BackgroundMesh background = background_of([](Point) { return Metric{}; }, {-1, -1}, {11, 11});
  QuadWork work;
  explicit UnitCase(const MixedMesh& mesh, const QuadWeights& weights = {})
      : work(work_on(background, mesh, weights)) {}
};

/// Moves the vertices off the segments by up to `size` in both directions.
inline void perturb(MixedMesh& mesh, std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> shift(-size, size);
  std::vector<char> fixed = mesh.required;
  for (const Segment& s : mesh.segments) fixed[s.a] = fixed[s.b] = 1;
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    const double x = shift(random), y = shift(random);
    if (!fixed[v]) mesh.vertices[v].p = mesh.vertices[v].p + Vector{x, y};
  }
}

inline std::vector<Index> live_half_edges(const QuadMesh& mesh) {
  std::vector<Index> result;
  for (Index h = 0; h < static_cast<Index>(mesh.corner.size()); ++h)
    if (mesh.corner[h] != kNoIndex) result.push_back(h);
  return result;
}

inline Index live_quads(const QuadMesh& mesh) {
  return static_cast<Index>(live_half_edges(mesh).size() / 4);
}

inline Index live_vertices(const QuadMesh& mesh) {
  return static_cast<Index>(std::count_if(mesh.leaving.begin(), mesh.leaving.end(),
                                          [](Index h) { return h != kNoIndex; }));
}

/// Number of quadrilaterals that are not strictly convex (exact predicate, no flat corners).
inline Index count_not_convex(const QuadMesh& mesh) {
  Index count = 0;
  for (Index q = 0; q < mesh.quad_count(); ++q) {
    if (mesh.is_dead(q)) continue;
    const Index h = 4 * q;
    const bool convex = is_convex_quad({mesh.vertex_at(h).p, mesh.vertex_at(h + 1).p,
                                        mesh.vertex_at(h + 2).p, mesh.vertex_at(h + 3).p});
    count += !convex;
  }
  return count;
}

/// Of the mesh as it is cut open.
inline Index euler_number(const QuadMesh& mesh) {
  Index inner = 0, rim = 0;
  for (const Index h : live_half_edges(mesh)) ++(mesh.twin[h] < 0 ? rim : inner);
  return live_vertices(mesh) - (inner / 2 + rim) + live_quads(mesh);
}

inline double signed_area(const QuadMesh& mesh) {
  double area = 0;
  for (const Index h : live_half_edges(mesh))
    area += 0.5 * cross(mesh.vertex_at(h).p, mesh.vertex_at(next_in_quad(h)).p);
  return area;
}

/// The half-edges along segments as segment, first and last vertex; sorted.
inline std::vector<std::array<Index, 3>> rim_of(const QuadMesh& mesh) {
  std::vector<std::array<Index, 3>> rim;
  for (const Index h : live_half_edges(mesh))
    if (mesh.twin[h] < 0)
      rim.push_back({~mesh.twin[h], mesh.corner[h], mesh.corner[next_in_quad(h)]});
  std::sort(rim.begin(), rim.end());
  return rim;
}

/// What is wrong with one live half-edge, or an empty text.
inline std::string broken_half_edge(const QuadMesh& mesh, Index h) {
  const Index a = mesh.corner[h], b = mesh.corner[next_in_quad(h)], t = mesh.twin[h];
  const auto count = static_cast<Index>(mesh.vertices.size());
  if (a < 0 || a >= count || b < 0 || b >= count) return "has no vertices";
  if (mesh.leaving[a] == kNoIndex) return "leaves a removed vertex";
  if (a == b || a == mesh.corner[opposite_in_quad(h)]) return "meets its vertex again";
  if (t < 0) return mesh.on_boundary(a) && mesh.on_boundary(b) ? "" : "is a rim inside";
  if (t >= static_cast<Index>(mesh.corner.size()) || mesh.is_dead(quad_of(t)))
    return "has a dead twin";
  if (mesh.twin[t] != h) return "is not the twin of its twin";
  if (quad_of(t) == quad_of(h)) return "has its twin in the same quadrilateral";
  if (mesh.corner[t] != b || mesh.corner[next_in_quad(t)] != a) return "has a twin elsewhere";
  return {};
}

/// What is wrong with one live vertex of which `uses` quadrilaterals have a corner.
inline std::string broken_vertex(const QuadMesh& mesh, Index v, int uses) {
  const Index first = mesh.leaving[v];
  if (mesh.corner[first] != v) return "is not left by its half-edge";
  if (mesh.on_boundary(v) != (mesh.twin[first] < 0)) return "has a wrong first half-edge";
  int count = 0;
  Index h = first;
  do {
    if (mesh.corner[h] != v) return "has a torn ring";
    ++count;
    h = anticlockwise(mesh, h);
  } while (h >= 0 && h != first && count <= uses);
  if ((h < 0) != mesh.on_boundary(v)) return "has an open ring or a closed fan";
  if (count != uses) return "has several fans";
  if (mesh.valence[v] != count) return "has a wrong valence";
  if (mesh.is_free(v) && count < 3) return "is a doublet";
  return {};
}

/// The first broken invariant, or an empty text: twins mutual and opposite, every directed edge
/// once, one ring or one fan around every vertex, no doublets.
inline std::string broken_invariant(const QuadMesh& mesh) {
  const std::size_t n = mesh.vertices.size();
  if (mesh.twin.size() != mesh.corner.size() || mesh.corner.size() % 4 ||
      mesh.leaving.size() != n || mesh.valence.size() != n || mesh.kind.size() != n ||
      mesh.original.size() != n)
    return "sizes of the arrays";
  std::set<std::array<Index, 2>> directed;
  std::vector<int> uses(n, 0);
  for (const Index h : live_half_edges(mesh)) {
    const std::string defect = broken_half_edge(mesh, h);
    if (!defect.empty()) return "half-edge " + std::to_string(h) + " " + defect;
    if (!directed.insert({mesh.corner[h], mesh.corner[next_in_quad(h)]}).second)
      return "half-edge " + std::to_string(h) + " is there twice";
    ++uses[mesh.corner[h]];
  }
  for (std::size_t v = 0; v < n; ++v) {
    if (mesh.leaving[v] == kNoIndex) continue;
    const std::string defect = broken_vertex(mesh, static_cast<Index>(v), uses[v]);
    if (!defect.empty()) return "vertex " + std::to_string(v) + " " + defect;
  }
  return {};
}

inline bool same_vertex(const WorkVertex& x, const WorkVertex& y) {
  return x.p == y.p && x.r.a == y.r.a && x.r.b == y.r.b && x.r.c == y.r.c && x.hint == y.hint;
}

/// The first thing in which the two differ, bit for bit, or an empty text.
inline std::string difference(const QuadWork& x, const QuadWork& y) {
  if (x.mesh.corner != y.mesh.corner) return "corner";
  if (x.mesh.twin != y.mesh.twin) return "twin";
  if (x.mesh.leaving != y.mesh.leaving) return "leaving";
  if (x.mesh.valence != y.mesh.valence) return "valence";
  if (x.mesh.kind != y.mesh.kind) return "kind";
  if (x.mesh.original != y.mesh.original) return "original";
  if (!std::equal(x.mesh.vertices.begin(), x.mesh.vertices.end(), y.mesh.vertices.begin(),
                  y.mesh.vertices.end(), same_vertex))
    return "vertices";
  if (x.energy != y.energy) return "energy";
  if (x.convex != y.convex) return "convex";
  if (x.ideal != y.ideal) return "ideal";
  if (x.changed_at != y.changed_at) return "changed_at";
  return {};
}

/// With the potential; from the definition.
inline double total_energy(const QuadWork& work) {
  double sum = 0;
  for (Index q = 0; q < work.mesh.quad_count(); ++q)
    if (!work.mesh.is_dead(q)) sum += work.energy_of(q).value - work.weights.potential;
  return sum;
}

inline constexpr int kOperationKinds = 5;

/// One operation with random arguments, also such as are out of range.
inline bool apply_random(QuadWork& work, std::mt19937_64& random, int kind) {
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const std::vector<Index> live = live_half_edges(work.mesh);
  const Index h = live[random() % live.size()];
  const Index v = work.mesh.corner[h];
  switch (kind) {
    case 0:
      return collapse_diagonal(work, h);
    case 1:
      return rotate_edge(work, h, 1 + below(2));
    case 2:
      return split_vertex(work, h, below(work.mesh.valence[v] + 2));
    case 3: {
      const int begin = below(work.mesh.valence[v] + 2) - 1;
      return split_boundary_vertex(work, v, begin, begin + below(work.mesh.valence[v] + 2));
    }
    default:
      return rotate_vertex(work, v);
  }
}

}  // namespace anisofront::testing
