#pragma once

// Triangulations by CGAL: the oracle of point location.
#include <algorithm>
#include <map>
#include <random>
#include <vector>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "mesher/geometry/predicates.hpp"
#include "mesher/mesh/mesh.hpp"
#include "tests/mesher/metric/random_metric.hpp"

namespace anisofront::testing {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

inline Kernel::Point_2 to_cgal(Point p) { return {p.x, p.y}; }

/// A mesh and the CGAL triangulation it consists of.
struct Oracle {
  Mesh mesh;
  Cdt cdt;
  std::map<Triangle, Index> triangle_of;  ///< sorted vertices -> triangle of the mesh

  /// The triangle of the mesh that CGAL finds, kNoIndex outside of the mesh.
  Index locate(Point p) const {
    const Cdt::Face_handle face = cdt.locate(to_cgal(p));
    if (face == nullptr || cdt.is_infinite(face)) return kNoIndex;
    const auto found = triangle_of.find(sorted(face));
    return found == triangle_of.end() ? kNoIndex : found->second;
  }
  static Triangle sorted(Cdt::Face_handle face) {
    Triangle t{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::sort(t.begin(), t.end());
    return t;
  }
};

/// Constrained Delaunay triangulation of points; faces whose centre fails `keep` are left out, so
/// that holes and non-convex domains appear.
template <class Keep>
inline Oracle triangulate(const std::vector<Point>& points, Keep&& keep) {
  Oracle oracle;
  oracle.mesh.points = points;
  for (std::size_t i = 0; i < points.size(); ++i)
    oracle.cdt.insert(to_cgal(points[i]))->info() = static_cast<Index>(i);
  if (points.size() > 3)
    oracle.cdt.insert_constraint(to_cgal(points[0]), to_cgal(points[points.size() / 2]));
  for (const Cdt::Face_handle face : oracle.cdt.finite_face_handles()) {
    const Triangle t{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    if (!keep((1. / 3) * (points[t[0]] + points[t[1]] + points[t[2]]))) continue;
    oracle.triangle_of[Oracle::sorted(face)] = static_cast<Index>(oracle.mesh.triangles.size());
    oracle.mesh.triangles.push_back(t);
  }
  return oracle;
}

inline std::vector<Point> random_points(std::mt19937_64& random, int count, Vector scale) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const Point p = random_point(random);
    points.push_back({scale.x * p.x, scale.y * p.y});
  }
  return points;
}

inline bool in_ring(Point p) {
  const double r = norm(p);
  return r > 0.35 && r < 0.9 && !(p.x > 0 && std::fabs(p.y) < 0.1);  // a C: hole and mouth
}

inline bool contains(const Mesh& mesh, Index triangle, Point p) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return orientation(mesh.points[a], mesh.points[b], p) >= 0 &&
         orientation(mesh.points[b], mesh.points[c], p) >= 0 &&
         orientation(mesh.points[c], mesh.points[a], p) >= 0;
}

inline bool any_contains(const Mesh& mesh, Point p) {
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
    if (contains(mesh, t, p)) return true;
  return false;
}

}  // namespace anisofront::testing
