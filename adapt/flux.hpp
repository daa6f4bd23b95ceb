#pragma once

#include <vector>

#include "solver/plate/solve_plate.hpp"
#include "solver/scalar/solve_scalar.hpp"

namespace anisofront {

/// Most components of FluxSamples.
inline constexpr int kMaxFluxComponents = 5;

/// Stresses of a solution at quadrature points of all elements, scaled so that the energy norm is
/// their L2 norm: sqrt(a) grad u (2 components) of a scalar, (C^-1/2 M, (k G t)^-1/2 Q) (3 + 2) of
/// a plate, where C^-1/2 is the symmetric root on (M_xx, M_yy, sqrt(2) M_xy).
/// The rules integrate squares of differences well enough for error estimates (degree 4 on
/// triangles and 3 x 3 points for second order, 2 x 2 points on quadrilaterals of first order). An
/// element of a single sample is one where the stresses are constant.
struct FluxSamples {
  int components = 0;
  int degree = 1;  ///< of the polynomials that recover them: one above that of the stresses
  std::vector<Index> first;  ///< samples of element e: first[e] .. first[e + 1] - 1
  std::vector<Point> points;
  std::vector<double> weights;  ///< of the quadrature over the domain (area of each sample)
  std::vector<double> values;   ///< `components` per sample
  std::vector<ReferencePoint> at;
  /// Per edge of the mesh: not 0 on curves inside a region across which the stresses jump as they
  /// carry a condition or a load of their own (supports, sources). Empty: none.
  std::vector<char> jumps;
};

/// All cores; the result does not depend on their number.
FluxSamples scalar_flux(const FeMesh& mesh, const ScalarProblem& problem, const ScalarField& field);
FluxSamples plate_flux(const FeMesh& mesh, const PlateProblem& problem,
                       const PlateSolution& solution);

/// The scaled stresses at one point of an element, `components` values.
std::vector<double> scalar_flux_at(const FeMesh& mesh, const ScalarProblem& problem,
                                   const ScalarField& field, const Element& element,
                                   ReferencePoint at);
std::vector<double> plate_flux_at(const FeMesh& mesh, const PlateProblem& problem,
                                  const PlateSolution& solution, const Element& element,
                                  ReferencePoint at);

}  // namespace anisofront
