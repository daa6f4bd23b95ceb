#pragma once

// What every generated mesh must fulfil, as a list of the sentences it breaks.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesher/generate.hpp"
#include "mesher/mesh/check.hpp"
#include "mesher/mesh/topology.hpp"

namespace anisofront::testing {

using Defects = std::vector<std::string>;

/// Distance of mesh points from their curves, relative to the size of the coordinates.
inline constexpr double kOnCurve = 1e-12;

inline double coordinate_size(const Mesh& mesh) {
  double size = 0;
  for (const Point p : mesh.points) size = std::max({size, std::fabs(p.x), std::fabs(p.y)});
  return size;
}

/// The edges of curve c in the order of their parameters cover the curve from end to end once, end
/// vertex to start vertex, and their vertices lie on it.
inline void check_curve(const Domain& domain, const Mesh& mesh, Index c, Defects& defects) {
  const DomainCurve& curve = domain.curves[c];
  std::vector<CurveEdge> edges;
  for (CurveEdge e : mesh.edges) {
    if (e.curve != c) continue;
    if (e.tag != curve.tag) defects.push_back(curve.name + ": wrong tag");
    if (e.parameters[0] > e.parameters[1]) {
      std::swap(e.parameters[0], e.parameters[1]);
      std::swap(e.vertices[0], e.vertices[1]);
    }
    edges.push_back(e);
  }
  if (edges.empty()) return defects.push_back(curve.name + ": no edges");
  std::sort(edges.begin(), edges.end(),
            [](const auto& e, const auto& f) { return e.parameters[0] < f.parameters[0]; });
  if (edges.front().parameters[0] != curve.curve.begin_parameter() ||
      edges.back().parameters[1] != curve.curve.end_parameter())
    defects.push_back(curve.name + ": ends are not reached");
  const double tolerance = kOnCurve * coordinate_size(mesh);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const CurveEdge& e = edges[i];
    if (!(e.parameters[0] < e.parameters[1])) defects.push_back(curve.name + ": no length");
    if (i > 0 && (edges[i - 1].parameters[1] != e.parameters[0] ||
                  edges[i - 1].vertices[1] != e.vertices[0]))
      defects.push_back(curve.name + ": a gap between its edges");
    for (int k = 0; k < 2; ++k)
      if (norm(evaluate(curve.curve, e.parameters[k]) - mesh.points[e.vertices[k]]) > tolerance)
        defects.push_back(curve.name + ": a vertex off the curve");
  }
}

/// Region tags agree with the loops: left of each use lies its region.
inline void check_regions(const Domain& domain, const Mesh& mesh, Defects& defects) {
  std::map<std::pair<Index, Index>, Index> region_left_of;  // directed edge -> tag
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      region_left_of[{mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]}] =
          mesh.triangle_regions[t];
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    for (int k = 0; k < 4; ++k)
      region_left_of[{mesh.quads[q][k], mesh.quads[q][(k + 1) % 4]}] = mesh.quad_regions[q];
  std::map<Index, std::vector<std::pair<Index, Index>>> along;  // curve -> edges along it
  for (const CurveEdge& e : mesh.edges) {
    const bool forward = e.parameters[0] < e.parameters[1];
    along[e.curve].push_back({e.vertices[forward ? 0 : 1], e.vertices[forward ? 1 : 0]});
  }
  for (const DomainRegion& region : domain.regions)
    for (const Loop& loop : region.loops)
      for (const CurveUse use : loop)
        for (const auto& [a, b] : along[use.curve]) {
          const auto found = region_left_of.find(use.reversed ? std::pair{b, a} : std::pair{a, b});
          if (found == region_left_of.end() || found->second != region.tag)
            defects.push_back(domain.curves[use.curve].name + ": region " + region.name +
                              " is not beside it");
        }
}

inline void check_points(const Domain& domain, const Mesh& mesh, Defects& defects) {
  if (mesh.required_vertices.size() != domain.points.size())
    return defects.push_back("number of required vertices");
  const double tolerance = kOnCurve * coordinate_size(mesh);
  for (std::size_t i = 0; i < domain.points.size(); ++i) {
    const Index v = mesh.required_vertices[i];
    if (v < 0 || norm(mesh.points[v] - domain.points[i].point) > tolerance)
      defects.push_back(domain.points[i].name + " is no vertex");
    else if (domain.points[i].tag != 0 && mesh.vertex_tags[v] != domain.points[i].tag)
      defects.push_back(domain.points[i].name + " has lost its tag");
  }
}

/// `area` < 0: not checked (curved boundaries).
inline Defects defects_of(const Domain& domain, const GenerateResult& result, double area,
                          Index holes) {
  const Mesh& mesh = result.mesh;
  const MeshReport report = check_mesh(mesh);
  Defects defects = report.defects;
  if (!defects.empty()) return defects;
  if (result.metric.size() != mesh.points.size()) defects.push_back("one metric per vertex");
  if (area >= 0 && std::fabs(report.area - area) > 1e-12 * area)
    defects.push_back("area " + std::to_string(report.area) + " instead of " +
                      std::to_string(area));
  if (report.holes != holes)
    defects.push_back(std::to_string(report.holes) + " holes instead of " + std::to_string(holes));
  std::set<Index> used;
  for (const DomainRegion& region : domain.regions) {
    for (const Loop& loop : region.loops)
      for (const CurveUse use : loop) used.insert(use.curve);
    used.insert(region.embedded_curves.begin(), region.embedded_curves.end());
  }
  for (const Index c : used) check_curve(domain, mesh, c, defects);
  check_regions(domain, mesh, defects);
  check_points(domain, mesh, defects);
  return defects;
}

inline std::string joined(const Defects& defects) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(defects.size(), 5); ++i)
    text += defects[i] + "\n";
  return text;
}

}  // namespace anisofront::testing
