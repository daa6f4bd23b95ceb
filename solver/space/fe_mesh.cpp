#include "solver/space/fe_mesh.hpp"

#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

template <std::size_t N>
void set_corners(const FeMesh& fe, const std::array<Index, N>& vertices,
                 const std::array<Index, N>& edges, Element& element) {
  element.corners = static_cast<int>(N);
  for (std::size_t k = 0; k < N; ++k) {
    element.vertices[k] = vertices[k];
    element.edges[k] = edges[k];
    element.nodes[k] = fe.mesh.points[vertices[k]];
    element.nodes[N + k] = fe.edge_points[edges[k]];
    element.bent = element.bent || fe.edge_is_bent[edges[k]];
  }
}

/// Transfinite interpolation of the four sides at the centre.
Point centre_of(const std::array<Point, 9>& nodes) {
  Vector corners{}, sides{};
  for (int k = 0; k < 4; ++k) {
    corners = corners + nodes[k];
    sides = sides + nodes[4 + k];
  }
  return 0.5 * sides - 0.25 * corners;
}

Index region_at(const std::vector<Index>& regions, std::size_t element) {
  return element < regions.size() ? regions[element] : 0;
}

}  // namespace

FeMesh straight_fe_mesh(const Mesh& mesh) {
  if (mesh.triangles.empty() && mesh.quads.empty())
    throw InputError("the mesh has no elements; expected triangles or quadrilaterals");
  FeMesh fe{mesh, number_edges(mesh), {}, {}, {}};
  for (const auto& [a, b] : fe.edges.vertices)
    fe.edge_points.push_back(lerp(mesh.points[a], mesh.points[b], 0.5));
  fe.edge_is_bent.assign(fe.edge_points.size(), 0);
  for (const CurveEdge& edge : mesh.edges) {
    const Vector chord = mesh.points[edge.vertices[1]] - mesh.points[edge.vertices[0]];
    const Vector tangent = (1 / norm(chord)) * chord;
    fe.curve_tangents.push_back({tangent, tangent});
  }
  return fe;
}

Element element_at(const FeMesh& fe, Index number) {
  Element element;
  element.number = number;
  const std::size_t triangles = fe.mesh.triangles.size();
  auto e = static_cast<std::size_t>(number);
  if (e < triangles) {
    element.region = region_at(fe.mesh.triangle_regions, e);
    set_corners(fe, fe.mesh.triangles[e], fe.edges.triangle_edges[e], element);
    return element;
  }
  e -= triangles;
  element.shape = Shape::quadrilateral;
  element.region = region_at(fe.mesh.quad_regions, e);
  set_corners(fe, fe.mesh.quads[e], fe.edges.quad_edges[e], element);
  element.nodes[8] = centre_of(element.nodes);
  return element;
}

}  // namespace anisofront
