#include "solver/scalar/boundary_flux.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "mesher/geometry/error.hpp"
#include "solver/scalar/reference_side.hpp"
#include "solver/scalar/scalar_boundary.hpp"
#include "solver/scalar/scalar_system.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

/// The flux through an edge that belongs to the vertex function of one of its ends, and the length
/// that does.
struct EndFlux {
  double flux = 0, length = 0;

  EndFlux& operator+=(const EndFlux& b) {
    flux += b.flux;
    length += b.length;
    return *this;
  }
};

/// int a du_h/dn N over side k of the element, N the function of the vertex `end`.
EndFlux end_flux(const ScalarOnElement& u, const Coefficient& diffusion, int k, Index end) {
  const ReferenceSide side(u.element.shape, k);
  const bool at_start = u.element.vertices[k] == end;
  EndFlux sum;
  for (const auto& [s, weight] : edge_quadrature(kFluxDegree)) {
    const ReferencePoint at = side.at(s);
    const MapPoint map = map_at(u.element, at);
    const Vector tangent = side.direction.x * map.d_xi + side.direction.y * map.d_eta;
    const Vector normal{tangent.y, -tangent.x};  // times ds / dt
    const double t = at_start ? s : 1 - s;
    const double trace = u.order == 1 ? 1 - t : (1 - t) * (1 - 2 * t);
    sum += {weight * trace * diffusion(map.x) * dot(u.at(at).gradient, normal),
            weight * (1 - t) * norm(tangent)};
  }
  return sum;
}

/// Which prescribed curves meet in each vertex.
enum : char { kOwn = 1, kOther = 2 };

std::vector<char> prescribed_at_vertices(const Mesh& mesh, const ScalarProblem& problem,
                                         Index tag) {
  std::vector<char> marks(mesh.points.size(), 0);
  for (const CurveEdge& edge : mesh.edges)
    if (condition_on(problem.dirichlet, edge.tag) >= 0)
      for (const Index v : edge.vertices)
        marks[v] = static_cast<char>(marks[v] | (edge.tag == tag ? kOwn : kOther));
  return marks;
}

/// Direct fluxes at a vertex: of the edges with the tag, and of all prescribed edges.
struct VertexFlux {
  EndFlux own, all;
};

/// At the vertices that the tag shares with other prescribed curves.
std::vector<VertexFlux> fluxes_at_shared(const FeMesh& mesh, const ScalarProblem& problem,
                                         const ScalarField& field, Index tag) {
  const std::vector<char> marks = prescribed_at_vertices(mesh.mesh, problem, tag);
  std::vector<Index> tag_of_edge(mesh.edges.count(), kNoIndex);
  for (std::size_t i = 0; i < mesh.mesh.edges.size(); ++i)
    if (condition_on(problem.dirichlet, mesh.mesh.edges[i].tag) >= 0)
      tag_of_edge[mesh.edges.curve_edges[i]] = mesh.mesh.edges[i].tag;
  std::vector<VertexFlux> fluxes(mesh.mesh.points.size());
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    for (int k = 0; k < element.corners; ++k) {
      const Index edge_tag = tag_of_edge[element.edges[k]];
      if (edge_tag == kNoIndex) continue;
      for (const Index v : {element.vertices[k], element.vertices[(k + 1) % element.corners]}) {
        if (marks[v] != (kOwn | kOther)) continue;
        const EndFlux flux =
            end_flux(on_element(mesh, field, element), problem.diffusion.in(element.region), k, v);
        fluxes[v].all += flux;
        if (edge_tag == tag) fluxes[v].own += flux;
      }
    }
  }
  return fluxes;
}

/// What the system's equations leave over at the unknowns of the tag.
double reaction(const FeMesh& mesh, const ScalarProblem& problem, const ScalarField& field,
                Index tag, int threads) {
  const LinearSystem system = scalar_system(mesh, problem, field.dofs, field.order, threads);
  const Eigen::Map<const Eigen::VectorXd> u(field.values.data(), system.rhs.size());
  const Eigen::VectorXd residual = system.matrix * u - system.rhs;
  const auto shared = fluxes_at_shared(mesh, problem, field, tag);
  std::vector<char> counted(residual.size(), 0);
  double sum = 0;
  for (Index i = 0; i < static_cast<Index>(mesh.mesh.edges.size()); ++i) {
    if (mesh.mesh.edges[i].tag != tag) continue;
    const CurveUnknowns unknowns = curve_unknowns(mesh, field.dofs, i);
    for (int k = 0; k < unknowns.count; ++k) {
      const Index unknown = unknowns.numbers[k];
      if (std::exchange(counted[unknown], 1)) continue;
      sum += residual[unknown];
      if (k == 2 || shared[unknown].all.length == 0) continue;
      const auto& [own, all] = shared[unknown];
      const double correction = residual[unknown] - all.flux;
      sum += own.flux + own.length / all.length * correction - residual[unknown];
    }
  }
  return sum;
}

double prescribed_flux(const FeMesh& mesh, const FluxCondition& condition,
                       const ScalarField& field) {
  double sum = 0;
  for (Index i = 0; i < static_cast<Index>(mesh.mesh.edges.size()); ++i) {
    if (mesh.mesh.edges[i].tag != condition.tag) continue;
    const CurveUnknowns unknowns = curve_unknowns(mesh, field.dofs, i);
    for (const auto& [t, weight] : edge_quadrature(kFluxDegree)) {
      const CurvePoint at = curve_point(mesh, i, t);
      const auto trace = unknowns.trace(t);
      double u = 0;
      for (int k = 0; k < unknowns.count; ++k) u += trace[k] * field.values[unknowns.numbers[k]];
      sum += weight * at.speed * (condition.flux(at.x) - condition.transfer(at.x) * u);
    }
  }
  return sum;
}

}  // namespace

double total_flux(const FeMesh& mesh, const ScalarProblem& problem, const ScalarField& field,
                  Index tag, int threads) {
  const auto& edges = mesh.mesh.edges;
  if (std::none_of(edges.begin(), edges.end(), [tag](const auto& e) { return e.tag == tag; }))
    throw InputError("flux over tag " + std::to_string(tag) + " (\"" +
                     group_name(mesh.mesh, 1, tag) + "\"): no edge of the mesh carries it");
  if (condition_on(problem.dirichlet, tag) >= 0)
    return reaction(mesh, problem, field, tag, threads);
  const int k = condition_on(problem.fluxes, tag);
  return k >= 0 ? prescribed_flux(mesh, problem.fluxes[k], field) : 0;
}

}  // namespace anisofront
