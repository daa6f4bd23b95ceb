#pragma once

#include <span>

#include "adapt/hessian.hpp"
#include "mesher/mesh/mesh.hpp"
#include "solver/scalar/scalar_problem.hpp"

namespace anisofront {

/// Error estimate of a P1 solution in the energy norm sqrt(int a |grad v|^2 + c v^2).
struct EnergyEstimate {
  double error = 0;   ///< sqrt(int a |G - grad u_h|^2), G: recovered gradients, linear in elements
  double energy = 0;  ///< sqrt(int a |G|^2 + c u_h^2)
  double relative() const { return error / energy; }
};

/// O. C. Zienkiewicz, J. Z. Zhu, A simple error estimator and adaptive procedure, Int. J. Numer.
/// Meth. Engng 24 (1987) 337-357, doi:10.1002/nme.1620240206, with the gradients of the quadratic
/// fits. The reaction term of the error is of higher order and left out. Zero for quadratics that
/// are linear. Coefficients are taken at the centroids. `values`, `quadratics`: one per vertex.
EnergyEstimate estimate_energy_error(const Mesh& mesh, const ScalarProblem& problem,
                                     std::span<const double> values,
                                     std::span<const LocalQuadratic> quadratics);

}  // namespace anisofront
