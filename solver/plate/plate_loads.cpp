#include "solver/plate/plate_loads.hpp"

#include <cmath>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "solver/plate/nearest_vertex.hpp"
#include "solver/space/basis.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

/// Quadratic traces times quadratic loads on an edge of second degree, and some more for the root
/// in ds/dt.
constexpr int kDegree = 9;

/// Shape functions of the three nodes of an edge: two vertices, the edge itself.
using Trace = std::array<double, 3>;

Trace linear(double t) {
  const auto [a, b] = linear_trace(t);
  return {a, b, 0};
}

Trace deflection_trace(PlateElement element, double t) {
  if (element == PlateElement::mitc) return quadratic_trace(t);
  if (element == PlateElement::mitc4) return linear(t);
  return {0, 0, 1};
}

Trace rotation_trace(PlateElement element, double t) {
  return element == PlateElement::mitc ? quadratic_trace(t) : linear(t);
}

/// Adds force and couple at a point of an edge.
struct EdgeLoading {
  const DofMap& dofs;
  PlateElement element;
  Eigen::VectorXd& rhs;

  void add(const std::array<Index, 2>& vertices, Index edge, double t, double force,
           Vector couple) const {
    const Trace w = deflection_trace(element, t), theta = rotation_trace(element, t);
    const PlateComponents at_vertex = vertex_components(element);
    for (int k = 0; k < 2; ++k)
      add(dofs.at_vertex(vertices[k]), at_vertex, w[k] * force, theta[k] * couple);
    add(dofs.at_edge(edge), edge_components(element), w[2] * force, theta[2] * couple);
  }

 private:
  void add(Index first, PlateComponents components, double force, Vector couple) const {
    if (components.w >= 0) rhs[first + components.w] += force;
    if (components.rotation < 0) return;
    rhs[first + components.rotation] += couple.x;
    rhs[first + components.rotation + 1] += couple.y;
  }
};

}  // namespace

void add_edge_loads(const FeMesh& mesh, const DofMap& dofs, PlateElement element,
                    const PlateProblem& problem, Eigen::VectorXd& rhs) {
  const EdgeLoading loading{dofs, element, rhs};
  for (const PlateEdgeLoad& load : problem.edge_loads)
    for (std::size_t i = 0; i < mesh.mesh.edges.size(); ++i) {
      const CurveEdge& edge = mesh.mesh.edges[i];
      if (edge.tag != load.tag) continue;
      for (const auto& [t, weight] : edge_quadrature(kDegree)) {
        const CurvePoint at = curve_point(mesh, static_cast<Index>(i), t);
        const double ds = weight * at.speed;
        const Vector n{at.tangent.y, -at.tangent.x}, s = at.tangent;
        const double force = finite_value(load.shear, at.x, "the shear force of an edge load");
        const double bending = finite_value(load.moment, at.x, "the moment of an edge load");
        const double twist = finite_value(load.twist, at.x, "the twisting moment of an edge load");
        loading.add(edge.vertices, mesh.edges.curve_edges[i], t, ds * force,
                    -ds * (bending * n + twist * s));
      }
    }
}

void add_point_loads(const FeMesh& mesh, const DofMap& dofs, PlateElement element,
                     const PlateProblem& problem, Eigen::VectorXd& rhs) {
  const int w = vertex_components(element).w;
  for (const PlatePointLoad& load : problem.point_loads) {
    if (w < 0)
      throw UsageError("these elements have no deflection at vertices to carry the point load at " +
                       describe(load.at) + ": use mitc elements");
    rhs[dofs.at_vertex(nearest_vertex(mesh, load.at, "the point load"), w)] += load.force;
  }
}

LoadResultant resultant(const FeMesh& mesh, const DofMap& dofs, PlateElement element,
                        const Eigen::VectorXd& rhs) {
  LoadResultant sum;
  const auto add = [&](Index first, PlateComponents components, Point at) {
    if (components.w >= 0) {
      const double force = rhs[first + components.w];
      sum.force += force;
      sum.absolute += std::abs(force);
      sum.moment = sum.moment + force * at;
    }
    if (components.rotation < 0) return;
    sum.moment =
        sum.moment + Vector{rhs[first + components.rotation], rhs[first + components.rotation + 1]};
  };
  for (Index v = 0; v < dofs.vertices; ++v)
    add(dofs.at_vertex(v), vertex_components(element), mesh.mesh.points[v]);
  for (Index e = 0; e < dofs.edges; ++e)
    add(dofs.at_edge(e), edge_components(element), mesh.edge_points[e]);
  return sum;
}

}  // namespace anisofront
