#include "solver/scalar/scalar_boundary.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "solver/space/basis.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

/// A point counts as a vertex within this share of the diagonal of the mesh.
constexpr double kSamePlace = 1e-9;

std::string name_of(const Mesh& mesh, Index tag) {
  return "tag " + std::to_string(tag) + " (\"" + group_name(mesh, 1, tag) + "\")";
}

template <class Condition>
void require_edges(const Mesh& mesh, const std::vector<Condition>& conditions) {
  for (const Condition& condition : conditions)
    if (std::none_of(mesh.edges.begin(), mesh.edges.end(),
                     [&](const CurveEdge& edge) { return edge.tag == condition.tag; }))
      throw InputError("boundary condition on " + name_of(mesh, condition.tag) +
                       ": no edge of the mesh carries it; check the curve names");
}

void require_single(const Mesh& mesh, const ScalarProblem& problem) {
  std::vector<Index> tags;
  for (const auto& condition : problem.dirichlet) tags.push_back(condition.tag);
  for (const auto& condition : problem.fluxes) tags.push_back(condition.tag);
  std::sort(tags.begin(), tags.end());
  if (const auto twice = std::adjacent_find(tags.begin(), tags.end()); twice != tags.end())
    throw InputError(name_of(mesh, *twice) +
                     " has two boundary conditions, expected one: a value or a flux");
}

/// Which Dirichlet condition prescribes each unknown, or -1.
std::vector<int> conditions_of_unknowns(const FeMesh& mesh, const ScalarProblem& problem,
                                        const DofMap& dofs) {
  std::vector<int> owner(dofs.count(), -1);
  for (Index i = 0; i < static_cast<Index>(mesh.mesh.edges.size()); ++i) {
    const int condition = condition_on(problem.dirichlet, mesh.mesh.edges[i].tag);
    if (condition < 0) continue;
    const CurveUnknowns unknowns = curve_unknowns(mesh, dofs, i);
    for (int k = 0; k < unknowns.count; ++k) {
      int& first = owner[unknowns.numbers[k]];
      if (first < 0 || condition < first) first = condition;
    }
  }
  return owner;
}

std::vector<char> vertices_in_use(const Mesh& mesh) {
  std::vector<char> used(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles)
    for (const Index v : t) used[v] = 1;
  for (const Quad& q : mesh.quads)
    for (const Index v : q) used[v] = 1;
  return used;
}

Index nearest_vertex(const Mesh& mesh, const std::vector<char>& used, Point p) {
  Index nearest = kNoIndex;
  double least = std::numeric_limits<double>::infinity();
  for (Index v = 0; v < static_cast<Index>(mesh.points.size()); ++v) {
    const double d = used[v] ? squared_norm(mesh.points[v] - p) : least;
    if (d < least) {
      least = d;
      nearest = v;
    }
  }
  if (nearest == kNoIndex)
    throw InputError("the place " + describe(p) + " of a point value is not finite");
  return nearest;
}

double diagonal(const Mesh& mesh) {
  Point low = mesh.points.front(), high = low;
  for (const Point p : mesh.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return norm(high - low);
}

void add_point_values(const Mesh& mesh, const ScalarProblem& problem, const Monitor& monitor,
                      std::vector<int> owner, std::vector<Constraint>& constraints) {
  if (problem.points.empty()) return;
  const std::vector<char> used = vertices_in_use(mesh);
  const double tolerance = kSamePlace * diagonal(mesh);
  for (const PointValue& point : problem.points) {
    const Index v = nearest_vertex(mesh, used, point.at);
    const Point place = mesh.points[v];
    if (owner[v] >= 0)
      throw InputError("the value at the point " + describe(point.at) + " falls on the vertex " +
                       describe(place) + ", which has another condition already");
    owner[v] = static_cast<int>(problem.dirichlet.size());
    if (norm(place - point.at) > tolerance)
      monitor.warning("the value at the point " + describe(point.at) +
                      " is imposed at the next vertex, " + describe(place) +
                      "; embed the point in the domain to get a vertex there");
    constraints.push_back({v, finite_value(point.value, place, "a point value")});
  }
}

/// The integrals of one condition over one edge.
void add_flux(const FeMesh& mesh, const FluxCondition& condition, const DofMap& dofs,
              Index curve_edge, LinearSystem& system) {
  const CurveUnknowns unknowns = curve_unknowns(mesh, dofs, curve_edge);
  const auto& numbers = unknowns.numbers;
  for (const auto& [t, weight] : edge_quadrature(kFluxDegree)) {
    const CurvePoint at = curve_point(mesh, curve_edge, t);
    const auto trace = unknowns.trace(t);
    const double ds = weight * at.speed;
    const double flux = finite_value(condition.flux, at.x, "the boundary flux");
    const double transfer = finite_value(condition.transfer, at.x, "the transfer coefficient");
    if (transfer < 0)
      throw InputError("the transfer coefficient is " + describe(transfer) + " at " +
                       describe(at.x) + ", expected no negative number");
    for (int i = 0; i < unknowns.count; ++i) {
      system.rhs[numbers[i]] += ds * flux * trace[i];
      if (transfer == 0) continue;
      for (int j = 0; j < unknowns.count; ++j)
        add_entry(system, numbers[i], numbers[j], ds * transfer * (trace[i] * trace[j]));
    }
  }
}

}  // namespace

void check_conditions(const Mesh& mesh, const ScalarProblem& problem) {
  require_edges(mesh, problem.dirichlet);
  require_edges(mesh, problem.fluxes);
  require_single(mesh, problem);
}

std::array<double, 3> CurveUnknowns::trace(double t) const {
  if (count == 3) return quadratic_trace(t);
  const auto [a, b] = linear_trace(t);
  return {a, b, 0};
}

CurveUnknowns curve_unknowns(const FeMesh& mesh, const DofMap& dofs, Index curve_edge) {
  const auto [a, b] = mesh.mesh.edges[curve_edge].vertices;
  CurveUnknowns unknowns{2, {dofs.at_vertex(a), dofs.at_vertex(b), kNoIndex}};
  if (dofs.layout.per_edge == 0) return unknowns;
  unknowns.count = 3;
  unknowns.numbers[2] = dofs.at_edge(mesh.edges.curve_edges[curve_edge]);
  return unknowns;
}

std::vector<Constraint> scalar_constraints(const FeMesh& mesh, const ScalarProblem& problem,
                                           const DofMap& dofs, const Monitor& monitor) {
  const std::vector<int> owner = conditions_of_unknowns(mesh, problem, dofs);
  std::vector<Constraint> constraints;
  for (Index u = 0; u < dofs.count(); ++u) {
    if (owner[u] < 0) continue;
    const Point p = u < dofs.vertices ? mesh.mesh.points[u] : mesh.edge_points[u - dofs.vertices];
    const DirichletCondition& condition = problem.dirichlet[owner[u]];
    const std::string what = "the boundary value on " + name_of(mesh.mesh, condition.tag);
    constraints.push_back({u, finite_value(condition.value, p, what.c_str())});
  }
  add_point_values(mesh.mesh, problem, monitor, owner, constraints);
  std::sort(constraints.begin(), constraints.end(),
            [](const Constraint& a, const Constraint& b) { return a.unknown < b.unknown; });
  return constraints;
}

void add_fluxes(const FeMesh& mesh, const ScalarProblem& problem, const DofMap& dofs,
                LinearSystem& system) {
  for (Index i = 0; i < static_cast<Index>(mesh.mesh.edges.size()); ++i)
    if (const int k = condition_on(problem.fluxes, mesh.mesh.edges[i].tag); k >= 0)
      add_flux(mesh, problem.fluxes[k], dofs, i, system);
}

}  // namespace anisofront
