#pragma once

#include <vector>

#include "mesher/geometry/monitor.hpp"
#include "solver/scalar/scalar_problem.hpp"
#include "solver/system/constraints.hpp"

namespace anisofront {

/// Throws InputError for conditions that contradict each other (a tag with two conditions) and for
/// tags that no edge of the mesh carries, with the name of the curve.
void check_conditions(const Mesh& mesh, const ScalarProblem& problem);

/// The unknowns (scalar_layout()) prescribed by Dirichlet conditions and point values, ascending:
/// the values at vertices and, for order 2, at the edge points. Warns of points that are not
/// vertices. Throws InputError for values that are not finite, with the place, and for point values
/// at vertices that are prescribed already.
std::vector<Constraint> scalar_constraints(const FeMesh& mesh, const ScalarProblem& problem,
                                           const DofMap& dofs, const Monitor& monitor = {});

/// Unknowns of a curve edge with the trace of its basis.
struct CurveUnknowns {
  int count = 2;
  std::array<Index, 3> numbers{};

  std::array<double, 3> trace(double t) const;
};
CurveUnknowns curve_unknowns(const FeMesh& mesh, const DofMap& dofs, Index curve_edge);

/// Adds int flux v - transfer u v over the edges with flux conditions. Throws InputError for values
/// that are not finite and for transfer < 0, with the place.
void add_fluxes(const FeMesh& mesh, const ScalarProblem& problem, const DofMap& dofs,
                LinearSystem& system);

/// Quadrature of the flux conditions along a curve edge.
inline constexpr int kFluxDegree = 7;

/// The number of the condition on this tag, or -1.
template <class Condition>
int condition_on(const std::vector<Condition>& conditions, Index tag) {
  for (std::size_t k = 0; k < conditions.size(); ++k)
    if (conditions[k].tag == tag) return static_cast<int>(k);
  return -1;
}

}  // namespace anisofront
