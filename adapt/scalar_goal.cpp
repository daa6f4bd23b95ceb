#include <algorithm>
#include <string>

#include "adapt/edge_sides.hpp"
#include "adapt/goal_mean.hpp"
#include "adapt/goal_trace.hpp"
#include "mesher/geometry/error.hpp"
#include "solver/plate/plate_text.hpp"
#include "solver/scalar/boundary_flux.hpp"
#include "solver/scalar/scalar_boundary.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

void require_symmetric(const ScalarProblem& problem) {
  if (problem.has_convection())
    throw InputError(
        "goal-oriented estimates are for symmetric problems, but this one has convection: use the "
        "energy error, or leave the velocity out");
}

void require_held(const Mesh& mesh, const ScalarProblem& problem, Index tag) {
  const std::string what = "goal: the flux through " + describe_tag(mesh, 1, tag);
  if (std::none_of(mesh.edges.begin(), mesh.edges.end(),
                   [tag](const CurveEdge& edge) { return edge.tag == tag; }))
    throw InputError(what + ": no edge of the mesh carries it; check the name of the curve");
  if (condition_on(problem.dirichlet, tag) < 0)
    throw InputError(what +
                     ": the value is not prescribed there, expected a curve with a prescribed "
                     "value, whose flux is a result");
}

/// Length of a curve edge that belongs to its vertex `end` (0 or 1), as total_flux() divides it.
double length_at_end(const FeMesh& mesh, Index curve_edge, int end) {
  double length = 0;
  for (const auto& [t, weight] : edge_quadrature(kFluxDegree))
    length += weight * (end == 0 ? 1 - t : t) * curve_point(mesh, curve_edge, t).speed;
  return length;
}

/// total_flux() gives to the curve its share of the lengths of all held edges that meet in a
/// vertex, edges inside counted from both sides, of all of the residual that the direct fluxes do
/// not account for.
ReactionShares reaction_shares(const FeMesh& mesh, const ScalarProblem& problem, Index tag) {
  struct Lengths {
    double own = 0, all = 0;
  };
  std::vector<Lengths> lengths(mesh.mesh.points.size());
  const EdgeSides sides = edge_sides(mesh);
  for (std::size_t i = 0; i < mesh.mesh.edges.size(); ++i) {
    const CurveEdge& edge = mesh.mesh.edges[i];
    if (condition_on(problem.dirichlet, edge.tag) < 0) continue;
    const bool inside = sides[mesh.edges.curve_edges[i]][1].element != kNoIndex;
    for (const int end : {0, 1}) {
      const double length = (inside ? 2 : 1) * length_at_end(mesh, static_cast<Index>(i), end);
      Lengths& at = lengths[edge.vertices[end]];
      at.all += length;
      if (edge.tag == tag) at.own += length;
    }
  }
  ReactionShares shares;
  for (std::size_t v = 0; v < lengths.size(); ++v)
    if (const auto& [own, all] = lengths[v]; own > 0 && own < all)
      shares.emplace_back(mesh.mesh.points[v], own / all);
  return shares;
}

}  // namespace

ScalarProblem dual_problem(const FeMesh& mesh, const ScalarProblem& problem, const Goal& goal) {
  require_symmetric(problem);
  ScalarProblem dual;
  dual.diffusion = problem.diffusion;
  dual.reaction = problem.reaction;
  const bool is_flux = goal.kind == Goal::Kind::curve_flux;
  if (is_flux) require_held(mesh.mesh, problem, goal.tag);
  if (!is_flux) dual.source = mean_source(mesh, goal);
  const ReactionShares shares =
      is_flux ? reaction_shares(mesh, problem, goal.tag) : ReactionShares{};
  for (const DirichletCondition& held : problem.dirichlet) {
    const bool is_goal = is_flux && held.tag == goal.tag;
    dual.dirichlet.push_back({held.tag, dual_trace(shares, is_goal ? -1 : 0)});
  }
  for (const FluxCondition& flux : problem.fluxes)
    if (!flux.transfer.is_zero()) dual.fluxes.push_back({flux.tag, 0., flux.transfer});
  for (const PointValue& point : problem.points) dual.points.push_back({point.at, 0});
  return dual;
}

double goal_value(const FeMesh& mesh, const ScalarProblem& problem, const ScalarSolution& solution,
                  const Goal& goal) {
  if (goal.kind == Goal::Kind::curve_flux) {
    require_held(mesh.mesh, problem, goal.tag);
    return total_flux(mesh, problem, solution.field, goal.tag);
  }
  return mean_of(mesh, goal_mean(mesh, goal), [&](const Element& element, ReferencePoint at) {
    return scalar_state(mesh, solution.field, element, at).value;
  });
}

}  // namespace anisofront
