#pragma once

// Fields and stresses that are known functions.
#include <functional>

#include "adapt/energy_estimate.hpp"
#include "solver/scalar/exact_solutions.hpp"
#include "solver/scalar/norms.hpp"
#include "solver/scalar/scalar_basis.hpp"
#include "tests/solver/square_mesh.hpp"

namespace anisofront::test {

/// The function that takes these values at the nodes.
inline ScalarField interpolant(const FeMesh& mesh, int order, const ScalarFunction& u) {
  ScalarField field{order, make_dof_map(mesh, scalar_layout(order)), {}, {}};
  for (const Point& p : mesh.mesh.points) field.values.push_back(u(p));
  if (order == 1) return field;
  for (const Point& p : mesh.edge_points) field.values.push_back(u(p));
  for (Index e = static_cast<Index>(mesh.mesh.triangles.size()); e < mesh.element_count(); ++e)
    field.inner.push_back(u(map_at(element_at(mesh, e), {0, 0}).x));
  return field;
}

/// Stresses as a function of region and place.
using Stresses = std::function<Vector(Index, Point)>;

/// Samples where those of elements of that order lie, with the values of a function.
inline FluxSamples samples_of(const FeMesh& mesh, int order, const Stresses& stresses) {
  FluxSamples samples = scalar_flux(mesh, {}, interpolant(mesh, order, [](Point) { return 0.; }));
  for (Index e = 0; e < mesh.element_count(); ++e)
    for (Index s = samples.first[e]; s < samples.first[e + 1]; ++s) {
      const Vector f = stresses(element_at(mesh, e).region, samples.points[s]);
      samples.values[2 * s] = f.x;
      samples.values[2 * s + 1] = f.y;
    }
  return samples;
}

/// Largest difference between recovered and given stresses over all elements, corners included.
inline double recovery_error(const FeMesh& mesh, const RecoveredFlux& recovered,
                             const Stresses& stresses) {
  double largest = 0;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    for (const ReferencePoint at : {ReferencePoint{0, 0}, {1, 0}, {0, 1}, {0.3, 0.4}}) {
      const Point x = map_at(element, at).x;
      double values[2];
      recovered.evaluate(element, x, corner_functions(element.shape, at), values);
      const Vector f = stresses(element.region, x);
      largest = std::max({largest, std::abs(values[0] - f.x), std::abs(values[1] - f.y)});
    }
  }
  return largest;
}

/// Elements left of x = 1/2 are region 1, the others region 2.
inline Mesh with_two_regions(Mesh mesh) {
  const auto region_of = [&](const auto& vertices) {
    double sum = 0;
    for (const Index v : vertices) sum += mesh.points[v].x;
    return sum < 0.5 * static_cast<double>(vertices.size()) ? 1 : 2;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    mesh.triangle_regions[t] = region_of(mesh.triangles[t]);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    mesh.quad_regions[q] = region_of(mesh.quads[q]);
  return mesh;
}

/// Tag of a curve inside.
inline constexpr Index kMiddle = 9;

/// Adds the edges between vertices on x = 1/2 with y <= top as a curve with tag kMiddle.
inline Mesh with_middle_curve(Mesh mesh, double top) {
  const FeMesh fe = straight_fe_mesh(mesh);
  std::vector<CurveEdge> added;
  for (const auto& [a, b] : fe.edges.vertices) {
    const Point p = mesh.points[a], q = mesh.points[b];
    if (p.x != 0.5 || q.x != 0.5 || std::max(p.y, q.y) > top) continue;
    CurveEdge edge;
    edge.vertices = {a, b};
    edge.tag = kMiddle;
    added.push_back(edge);
  }
  mesh.edges.insert(mesh.edges.end(), added.begin(), added.end());
  return mesh;
}

/// A view of a unit square whose bottom edges bulge out by `bulge`, which adds 2/3 of it to the
/// area.
inline FeMesh with_bent_bottom(const Mesh& mesh, double bulge) {
  FeMesh fe = straight_fe_mesh(mesh);
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    if (mesh.edges[i].tag != kBottom) continue;
    const Index edge = fe.edges.curve_edges[i];
    fe.edge_points[edge].y -= bulge;
    fe.edge_is_bent[edge] = 1;
  }
  return fe;
}

/// The problem of an exact solution on the unit square, prescribed on all sides.
inline ScalarProblem dirichlet_problem(const ExactSolution& exact, double diffusion,
                                       double reaction) {
  ScalarProblem problem;
  problem.diffusion = diffusion;
  problem.reaction = reaction;
  problem.source = exact.source;
  for (const Index side : {kBottom, kRight, kTop, kLeft})
    problem.dirichlet.push_back({side, exact.value});
  return problem;
}

/// A problem of dirichlet_problem(), solved on straight elements. The mesh must outlive it.
struct SolvedProblem {
  FeMesh mesh;
  ScalarProblem problem;
  ScalarField field;
  double true_error = 0;  ///< in the energy norm
};
inline SolvedProblem solved_problem(const Mesh& mesh, int order, const ExactSolution& exact,
                                    double diffusion, double reaction) {
  ScalarOptions options;
  options.order = order;
  const FeMesh fe = straight_fe_mesh(mesh);
  const ScalarProblem problem = dirichlet_problem(exact, diffusion, reaction);
  const ScalarField field = solve_scalar(fe, problem, options).field;
  return {fe, problem, field, error_norms(fe, problem, exact, field).energy};
}

/// Layers of width about 2 eps ln n along all sides take half of the n intervals.
inline Mesh shishkin(Mesh mesh, Index n, double eps) {
  const double width = 2 * eps * std::log(n);
  return mapped(std::move(mesh), [width](Point p) {
    return Point{layers_at_both_ends(p.x, width), layers_at_both_ends(p.y, width)};
  });
}

}  // namespace anisofront::test
