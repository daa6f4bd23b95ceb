#pragma once

// Triangle meshes to be paired and the laws that every mixed mesh made of them must keep.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mesher/enhance/enhance.hpp"
#include "mesher/mesh/topology.hpp"
#include "mesher/quads/pairing.hpp"
#include "tests/support/work_meshes.hpp"

namespace anisofront::testing {

using VertexPair = std::pair<Index, Index>;

inline const std::vector<Pairing> kPairings{Pairing::beta_order, Pairing::matching,
                                            Pairing::systematic};

/// Triangles with the unit metric; boundary edges and `walls` are segments.
inline WorkMesh work_mesh(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
                          const std::vector<VertexPair>& walls = {}) {
  WorkMesh mesh;
  for (const Point p : points) mesh.vertices.push_back({p, {}, 0});
  const TriangleNeighbours neighbours =
      triangle_neighbours(triangles, static_cast<Index>(points.size()));
  std::map<VertexPair, Index> segment_of;
  const auto segment = [&](Index a, Index b) {
    const auto [place, added] =
        segment_of.insert({std::minmax(a, b), static_cast<Index>(mesh.segments.size())});
    if (added) mesh.segments.push_back({a, b, 0, 0, 1, kNoIndex, kNoIndex});
    Segment& s = mesh.segments[place->second];
    (s.a == a ? s.left_region : s.right_region) = 0;
    return ~place->second;
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    mesh.triangles.push_back({triangles[t], neighbours[t]});
    for (int k = 0; k < 3; ++k) {
      const Index a = triangles[t][kNext[k]], b = triangles[t][kPrevious[k]];
      const bool wall = std::any_of(walls.begin(), walls.end(), [&](const VertexPair& w) {
        return std::minmax(w.first, w.second) == std::minmax(a, b);
      });
      if (wall || neighbours[t][k] == kNoIndex) mesh.triangles[t].neighbours[k] = segment(a, b);
    }
  }
  return mesh;
}

/// n x m unit squares, each cut along its diagonal from the lower left: 2 n m triangles. Vertex
/// (i, j) has number j (n + 1) + i.
inline WorkMesh right_triangles(Index n, Index m, const std::vector<VertexPair>& walls = {}) {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  for (Index j = 0; j <= m; ++j)
    for (Index i = 0; i <= n; ++i)
      points.push_back({static_cast<double>(i), static_cast<double>(j)});
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i, d = a + n + 1;
      triangles.push_back({a, a + 1, d + 1});
      triangles.push_back({a, d + 1, d});
    }
  return work_mesh(points, triangles, walls);
}

enum class Start { equilateral, right_angle };

/// The triangles of a domain as quadrilaterals are made from them.
inline void triangulate(WorkCase& work, Start start = Start::equilateral) {
  if (start == Start::right_angle) {
    work.advance(right_angle_front_options());
    return;
  }
  work.advance();
  Patch patch = make_patch(*work.background, work.mesh(), {});
  enhance(patch, {});
}

inline Index triangles_in(const MixedMesh& mesh) {
  return static_cast<Index>(std::count_if(mesh.faces.begin(), mesh.faces.end(),
                                          [](const MixedFace& f) { return !f.is_quad(); }));
}

inline double area_of(const MixedMesh& mesh) {
  double sum = 0;
  for (const MixedFace& f : mesh.faces)
    for (int k = 0; k < f.size(); ++k)
      sum += 0.5 *
             cross(mesh.vertices[f.vertices[k]].p, mesh.vertices[f.vertices[(k + 1) % f.size()]].p);
  return sum;
}

/// Directed edge -> its face, or an empty map when one comes twice.
inline std::map<VertexPair, Index> directed_edges(const MixedMesh& mesh) {
  std::map<VertexPair, Index> edges;
  for (Index f = 0; f < static_cast<Index>(mesh.faces.size()); ++f)
    for (int k = 0; k < mesh.faces[f].size(); ++k) {
      const auto& v = mesh.faces[f].vertices;
      if (!edges.insert({{v[k], v[(k + 1) % mesh.faces[f].size()]}, f}).second) return {};
    }
  return edges;
}

/// Triangles of each part that segments separate, in any order.
inline std::vector<Index> triangles_per_part(const MixedMesh& mesh) {
  const std::map<VertexPair, Index> edges = directed_edges(mesh);
  std::set<VertexPair> walls;
  for (const Segment& s : mesh.segments) walls.insert(std::minmax(s.a, s.b));
  std::vector<Index> part(mesh.faces.size());
  for (std::size_t f = 0; f < part.size(); ++f) part[f] = static_cast<Index>(f);
  const auto root = [&](Index f) {
    while (part[f] != f) f = part[f] = part[part[f]];
    return f;
  };
  for (const auto& [edge, f] : edges) {
    const auto other = edges.find({edge.second, edge.first});
    if (other != edges.end() && !walls.count(std::minmax(edge.first, edge.second)))
      part[root(f)] = root(other->second);
  }
  std::map<Index, Index> counts;
  for (std::size_t f = 0; f < part.size(); ++f)
    counts[root(static_cast<Index>(f))] += mesh.faces[f].is_quad() ? 0 : 1;
  std::vector<Index> result;
  for (const auto& [f, count] : counts) result.push_back(count);
  return result;
}

/// The first law broken by a mixed mesh made of these triangles, or an empty text: same vertices
/// and segments, no vertex without face, every directed edge once, the same boundary, every segment
/// an edge on the sides where it was one, nothing of the area and of the triangles lost.
inline std::string broken_law(const WorkMesh& before, const MixedMesh& after) {
  if (after.vertices.size() != before.vertices.size()) return "number of vertices";
  if (after.segments.size() != before.segments.size()) return "number of segments";
  Index halves = 0;
  std::set<Index> used;
  for (const MixedFace& f : after.faces) {
    const std::set<Index> distinct(f.vertices.begin(), f.vertices.begin() + f.size());
    if (static_cast<int>(distinct.size()) != f.size()) return "a face with a vertex twice";
    if (*distinct.begin() < 0 || *distinct.rbegin() >= static_cast<Index>(after.vertices.size()))
      return "a vertex out of range";
    halves += f.size() - 2;
    used.insert(distinct.begin(), distinct.end());
  }
  if (halves != live_triangles(before)) return "triangles lost or made";
  for (const WorkTriangle& t : before.triangles)
    for (const Index v : t.vertices)
      if (!t.dead() && !used.count(v)) return "a vertex lost";
  std::set<VertexPair> boundary, on_segments;
  for (const WorkTriangle& t : before.triangles)
    for (int k = 0; k < 3 && !t.dead(); ++k)
      if (t.neighbours[k] < 0) on_segments.insert({t.vertices[kNext[k]], t.vertices[kPrevious[k]]});
  for (const auto& [a, b] : on_segments)
    if (!on_segments.count({b, a})) boundary.insert({a, b});
  const std::map<VertexPair, Index> edges = directed_edges(after);
  if (edges.empty() && !after.faces.empty()) return "a directed edge twice";
  for (const auto& [edge, f] : edges)
    if (edges.count({edge.second, edge.first}) == boundary.count(edge))
      return "another boundary than before";
  for (const VertexPair& edge : on_segments)
    if (!edges.count(edge)) return "a side of a segment without face";
  const double area = area_of(before);
  if (std::fabs(area_of(after) - area) > 1e-11 * area) return "another area";
  return {};
}

}  // namespace anisofront::testing
