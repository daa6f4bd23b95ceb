#include "solver/scalar/held_parts.hpp"

#include <string>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "solver/space/disjoint_sets.hpp"
#include "solver/space/element_map.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

DisjointSets parts_of(const Mesh& mesh) {
  DisjointSets parts(mesh.points.size());
  for (const Triangle& t : mesh.triangles)
    for (const Index v : t) parts.unite(t[0], v);
  for (const Quad& q : mesh.quads)
    for (const Index v : q) parts.unite(q[0], v);
  return parts;
}

/// Degree 6 finds functions that are positive in a part of the element only.
bool has_reaction(const Element& element, const Coefficient& reaction) {
  if (reaction.is_constant()) return reaction({}) > 0;
  for (const WeightedPoint& q : reference_quadrature(element.shape, 6))
    if (reaction(map_at(element, q.at).x) > 0) return true;
  return false;
}

bool has_transfer(const FeMesh& mesh, Index curve_edge, const Coefficient& transfer) {
  if (transfer.is_constant()) return transfer({}) > 0;
  for (const EdgeQuadraturePoint& q : edge_quadrature(7))
    if (transfer(curve_point(mesh, curve_edge, q.t).x) > 0) return true;
  return false;
}

void hold_by_transfer(const FeMesh& mesh, const ScalarProblem& problem, DisjointSets& parts,
                      std::vector<char>& held) {
  for (Index i = 0; i < static_cast<Index>(mesh.mesh.edges.size()); ++i)
    for (const FluxCondition& condition : problem.fluxes)
      if (condition.tag == mesh.mesh.edges[i].tag && has_transfer(mesh, i, condition.transfer))
        held[parts.find(mesh.mesh.edges[i].vertices[0])] = 1;
}

void hold_by_reaction(const FeMesh& mesh, const ScalarProblem& problem, DisjointSets& parts,
                      std::vector<char>& held) {
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    const Index part = parts.find(element.vertices[0]);
    if (!held[part] && has_reaction(element, problem.reaction.in(element.region))) held[part] = 1;
  }
}

[[noreturn]] void throw_free(const Mesh& mesh, const Element& element) {
  const std::string name = group_name(mesh, 2, element.region);
  throw InputError("region " + std::to_string(element.region) +
                   (name.empty() ? "" : " (\"" + name + "\")") + ", the part around " +
                   describe(element.nodes[0]) +
                   ": u is free up to a constant; prescribe a value on one of its curves or at a "
                   "point, or give it a reaction or a boundary with transfer");
}

}  // namespace

void require_held_parts(const FeMesh& mesh, const ScalarProblem& problem,
                        std::span<const Constraint> constraints) {
  DisjointSets parts = parts_of(mesh.mesh);
  const auto vertices = static_cast<Index>(mesh.mesh.points.size());
  std::vector<char> held(mesh.mesh.points.size(), 0);
  for (const Constraint& constraint : constraints)
    if (constraint.unknown < vertices) held[parts.find(constraint.unknown)] = 1;
  hold_by_transfer(mesh, problem, parts, held);
  if (!problem.reaction.is_zero()) hold_by_reaction(mesh, problem, parts, held);
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    if (!held[parts.find(element.vertices[0])]) throw_free(mesh.mesh, element);
  }
}

}  // namespace anisofront
