#include "mesher/generate_collect.hpp"

#include <algorithm>
#include <utility>

namespace anisofront {
namespace {

std::vector<PhysicalGroup> groups_of(const Domain& domain) {
  std::vector<PhysicalGroup> groups;
  const auto add = [&](int dimension, Index tag, const std::string& name) {
    if (tag == 0 || name.empty()) return;
    for (const PhysicalGroup& g : groups)
      if (g.dimension == dimension && g.tag == tag) return;
    groups.push_back({dimension, tag, name});
  };
  for (const DomainPoint& p : domain.points) add(0, p.tag, p.name);
  for (const DomainCurve& c : domain.curves) add(1, c.tag, c.name);
  for (const DomainRegion& r : domain.regions) add(2, r.tag, r.name);
  return groups;
}

/// Region of each triangle, spread from the segments over the neighbours.
std::vector<Index> triangle_regions(const WorkMesh& work) {
  std::vector<Index> region(work.triangles.size(), kNoIndex);
  std::vector<Index> queue;
  for (std::size_t t = 0; t < work.triangles.size(); ++t) {
    const WorkTriangle& triangle = work.triangles[t];
    for (int k = 0; k < 3 && !triangle.dead(); ++k) {
      if (triangle.neighbours[k] >= 0) continue;
      const Segment& s = work.segments[~triangle.neighbours[k]];
      region[t] = triangle.vertices[kNext[k]] == s.a ? s.left_region : s.right_region;
      queue.push_back(static_cast<Index>(t));
      break;
    }
  }
  while (!queue.empty()) {
    const Index t = queue.back();
    queue.pop_back();
    for (const Index n : work.triangles[t].neighbours) {
      if (n < 0 || region[n] != kNoIndex) continue;
      region[n] = region[t];
      queue.push_back(n);
    }
  }
  return region;
}

/// Numbers of the vertices in the result: those in use, in order of creation.
std::vector<Index> compact_numbers(const WorkMesh& work) {
  std::vector<Index> number(work.vertices.size(), kNoIndex);
  for (const WorkTriangle& t : work.triangles)
    if (!t.dead())
      for (const Index v : t.vertices) number[v] = 0;
  Index next = 0;
  for (Index& n : number)
    if (n != kNoIndex) n = next++;
  return number;
}

void add_curve_edges(const Domain& domain, const WorkMesh& work, const std::vector<Index>& number,
                     Mesh& mesh) {
  for (const Segment& s : work.segments) {
    CurveEdge edge{{number[s.a], number[s.b]},
                   domain.curves[s.curve].tag,
                   s.curve,
                   {s.parameter_a, s.parameter_b}};
    if (s.left_region == kNoIndex) {  // the domain lies to the left of boundary edges
      std::swap(edge.vertices[0], edge.vertices[1]);
      std::swap(edge.parameters[0], edge.parameters[1]);
    }
    mesh.edges.push_back(edge);
  }
}

/// Ends of open curves are corners.
void add_corners(const Domain& domain, Mesh& mesh) {
  for (const CurveEdge& edge : mesh.edges) {
    const NurbsCurve& curve = domain.curves[edge.curve].curve;
    if (is_closed(curve)) continue;
    for (int k = 0; k < 2; ++k)
      if (edge.parameters[k] == curve.begin_parameter() ||
          edge.parameters[k] == curve.end_parameter())
        mesh.corners.push_back(edge.vertices[k]);
  }
  std::sort(mesh.corners.begin(), mesh.corners.end());
  mesh.corners.erase(std::unique(mesh.corners.begin(), mesh.corners.end()), mesh.corners.end());
}

void add_points(const Domain& domain, const std::vector<Index>& point_vertices,
                const std::vector<Index>& number, Mesh& mesh) {
  for (std::size_t i = 0; i < domain.points.size(); ++i) {
    const Index v = number[point_vertices[i]];
    mesh.required_vertices.push_back(v);
    if (domain.points[i].tag == 0) continue;
    mesh.vertex_tags.resize(mesh.points.size(), 0);
    mesh.vertex_tags[v] = domain.points[i].tag;
  }
}

}  // namespace

Collected collect(const Domain& domain, Boundary boundary) {
  const WorkMesh& work = boundary.mesh;
  Collected result;
  Mesh& mesh = result.mesh;
  const std::vector<Index> number = compact_numbers(work);
  mesh.points.reserve(work.vertices.size());
  result.metric.reserve(work.vertices.size());
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNoIndex) continue;
    mesh.points.push_back(work.vertices[v].p);
    result.metric.push_back(metric_of(work.vertices[v].r));
  }
  const std::vector<Index> region = triangle_regions(work);
  mesh.triangles.reserve(work.triangles.size());
  mesh.triangle_regions.reserve(work.triangles.size());
  for (std::size_t t = 0; t < region.size(); ++t) {
    if (work.triangles[t].dead()) continue;
    const auto& v = work.triangles[t].vertices;
    mesh.triangles.push_back({number[v[0]], number[v[1]], number[v[2]]});
    mesh.triangle_regions.push_back(domain.regions[region[t]].tag);
  }
  mesh.groups = groups_of(domain);
  add_curve_edges(domain, work, number, mesh);
  add_corners(domain, mesh);
  add_points(domain, boundary.point_vertices, number, mesh);
  return result;
}

}  // namespace anisofront
