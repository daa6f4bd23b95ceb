#include "mesher/generate_collect.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "mesher/generate_faces.hpp"
#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"

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

void add_vertices(const std::vector<WorkVertex>& vertices, const std::vector<Index>& number,
                  Collected& result) {
  result.mesh.points.reserve(vertices.size());
  result.metric.reserve(vertices.size());
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNoIndex) continue;
    result.mesh.points.push_back(vertices[v].p);
    result.metric.push_back(metric_of(vertices[v].r));
  }
}

/// Elements with their region tags, in new numbers.
class ElementAdder {
 public:
  ElementAdder(const Domain& domain, const std::vector<Index>& number, const Mesh& mesh)
      : domain_(domain), number_(number), mesh_(mesh) {}

  template <std::size_t N>
  void add(const std::array<Index, N>& vertices, Index region,
           std::vector<std::array<Index, N>>& elements, std::vector<Index>& tags) const {
    std::array<Index, N> renumbered;
    for (std::size_t k = 0; k < N; ++k) renumbered[k] = number_[vertices[k]];
    if (region == kNoIndex)
      throw MeshingError("the element at " + describe(mesh_.points[renumbered[0]]) +
                         " belongs to no region; please report it");
    elements.push_back(renumbered);
    tags.push_back(domain_.regions[region].tag);
  }

 private:
  const Domain& domain_;
  const std::vector<Index>& number_;
  const Mesh& mesh_;
};

void add_elements(const Domain& domain, const TriangleFaces& faces,
                  const std::vector<Index>& number, Mesh& mesh) {
  const std::vector<Index> region = face_regions(faces, faces.work.segments);
  const std::vector<WorkTriangle>& triangles = faces.work.triangles;
  mesh.triangles.reserve(triangles.size());
  mesh.triangle_regions.reserve(triangles.size());
  const ElementAdder adder(domain, number, mesh);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (!triangles[t].dead())
      adder.add(triangles[t].vertices, region[t], mesh.triangles, mesh.triangle_regions);
}

void add_elements(const Domain& domain, const MixedFaces& faces,
                  const std::vector<Segment>& segments, const std::vector<Index>& number,
                  Mesh& mesh) {
  const std::vector<Index> region = face_regions(faces, segments);
  mesh.triangles.reserve(faces.triangles().size());
  mesh.triangle_regions.reserve(faces.triangles().size());
  mesh.quads.reserve(faces.quads().size());
  mesh.quad_regions.reserve(faces.quads().size());
  const ElementAdder adder(domain, number, mesh);
  std::size_t f = 0;
  for (const Triangle& t : faces.triangles())
    adder.add(t, region[f++], mesh.triangles, mesh.triangle_regions);
  for (const Quad& q : faces.quads()) adder.add(q, region[f++], mesh.quads, mesh.quad_regions);
}

void add_curve_edges(const Domain& domain, const std::vector<Segment>& segments,
                     const std::vector<Index>& number, Mesh& mesh) {
  for (const Segment& s : segments) {
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
    const Index old = point_vertices[i];
    const Index v = old == kNoIndex ? kNoIndex : number[old];
    if (v == kNoIndex)
      throw MeshingError("the point \"" + domain.points[i].name + "\" at " +
                         describe(domain.points[i].point) +
                         " is no vertex of the mesh; please report it");
    mesh.required_vertices.push_back(v);
    if (domain.points[i].tag == 0) continue;
    mesh.vertex_tags.resize(mesh.points.size(), 0);
    mesh.vertex_tags[v] = domain.points[i].tag;
  }
}

/// What does not depend on the kind of the elements.
void add_skeleton(const Domain& domain, const std::vector<Segment>& segments,
                  const std::vector<Index>& point_vertices, const std::vector<Index>& number,
                  Mesh& mesh) {
  mesh.groups = groups_of(domain);
  add_curve_edges(domain, segments, number, mesh);
  add_corners(domain, mesh);
  add_points(domain, point_vertices, number, mesh);
}

}  // namespace

void require_quadrilaterals(const MixedMesh& mesh) {
  const auto is_triangle = [](const MixedFace& face) { return !face.is_quad(); };
  const auto first = std::find_if(mesh.faces.begin(), mesh.faces.end(), is_triangle);
  if (first == mesh.faces.end()) return;
  throw MeshingError(std::to_string(std::count_if(first, mesh.faces.end(), is_triangle)) +
                     " triangles could not be turned into quadrilaterals, the first at " +
                     describe(mesh.vertices[first->vertices[0]].p) +
                     "; refine the metric there, or ask for mixed elements, which keep triangles");
}

Collected collect(const Domain& domain, Boundary boundary) {
  const WorkMesh& work = boundary.mesh;
  const TriangleFaces faces{work};
  Collected result;
  const std::vector<Index> number = compact_numbers(faces, work.vertices.size());
  add_vertices(work.vertices, number, result);
  add_elements(domain, faces, number, result.mesh);
  add_skeleton(domain, work.segments, boundary.point_vertices, number, result.mesh);
  return result;
}

Collected collect(const Domain& domain, MixedMesh work, const std::vector<Index>& point_vertices) {
  const MixedFaces faces(work.faces, work.segments, work.vertices.size());
  work.faces = std::vector<MixedFace>();  // unlike {}, which keeps the capacity
  Collected result;
  const std::vector<Index> number = compact_numbers(faces, work.vertices.size());
  add_vertices(work.vertices, number, result);
  add_elements(domain, faces, work.segments, number, result.mesh);
  add_skeleton(domain, work.segments, point_vertices, number, result.mesh);
  return result;
}

}  // namespace anisofront
