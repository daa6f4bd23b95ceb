#pragma once

#include "solver/scalar/norms.hpp"
#include "solver/scalar/solve_scalar.hpp"
#include "tests/solver/square_mesh.hpp"

namespace anisofront::test {

/// -div(a grad u) + c u = f on the unit square, u given on all four sides.
inline ScalarProblem with_values(RegionCoefficient a, RegionCoefficient c, RegionCoefficient source,
                                 const Coefficient& value) {
  ScalarProblem problem{std::move(a), std::move(c), std::move(source)};
  for (const Index side : {kBottom, kRight, kTop, kLeft})
    problem.dirichlet.push_back({side, value});
  return problem;
}

/// The problem that has this exact solution.
inline ScalarProblem problem_of(const ExactSolution& exact, double a, double c) {
  return with_values(a, c, exact.source, exact.value);
}

inline ScalarOptions of_order(int order) {
  ScalarOptions options;
  options.order = order;
  options.threads = 1;  // small systems on a busy machine
  return options;
}

inline ScalarSolution solve_straight(const Mesh& mesh, const ScalarProblem& problem, int order) {
  return solve_scalar(straight_fe_mesh(mesh), problem, of_order(order));
}

inline ErrorNorms solve_and_compare(const FeMesh& mesh, const ScalarProblem& problem,
                                    const ExactSolution& exact, int order) {
  return error_norms(mesh, problem, exact, solve_scalar(mesh, problem, of_order(order)).field);
}
inline ErrorNorms solve_and_compare(const Mesh& mesh, const ScalarProblem& problem,
                                    const ExactSolution& exact, int order) {
  return solve_and_compare(straight_fe_mesh(mesh), problem, exact, order);
}

/// Largest |u_h - u| over all nodes: vertices, edge points, centres of quadrilaterals.
inline double nodal_error(const FeMesh& mesh, const ScalarField& field, const ScalarFunction& u) {
  double error = 0;
  const auto compare = [&](double value, Point p) {
    error = std::max(error, std::abs(value - u(p)));
  };
  for (Index v = 0; v < field.dofs.vertices; ++v) compare(field.values[v], mesh.mesh.points[v]);
  if (field.order == 1) return error;
  for (Index e = 0; e < mesh.edges.count(); ++e)
    compare(field.values[field.dofs.at_edge(e)], mesh.edge_points[e]);
  const auto triangles = static_cast<Index>(mesh.mesh.triangles.size());
  for (std::size_t q = 0; q < field.inner.size(); ++q)
    compare(field.inner[q], element_at(mesh, triangles + static_cast<Index>(q)).nodes[8]);
  return error;
}

}  // namespace anisofront::test
