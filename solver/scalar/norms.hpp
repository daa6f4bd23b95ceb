#pragma once

#include "solver/scalar/exact_solutions.hpp"
#include "solver/scalar/scalar_field.hpp"

namespace anisofront {

/// Norms of the error e = u - u_h of a field and of the exact solution.
struct ErrorNorms {
  double l2 = 0;            ///< sqrt(int e^2)
  double h1 = 0;            ///< sqrt(int |grad e|^2)
  double energy = 0;        ///< sqrt(int a |grad e|^2 + c e^2)
  double exact_energy = 0;  ///< sqrt(int a |grad u|^2 + c u^2)
  double relative_energy() const { return energy / exact_energy; }
};

/// Quadrature of degree 8, with elements subdivided where u is far from linear or where rules of
/// different degree disagree: the norms are accurate to about 1e-4 relative even when a layer of
/// the exact solution lies inside one element. Elements are divided on the reference element, so
/// that bent ones stay bent. The coefficients of `problem` may be functions of region and place.
/// `threads` 0: all cores; the result does not depend on it. Throws InputError with the place where
/// the field, the exact solution or a coefficient is not finite.
ErrorNorms error_norms(const FeMesh& mesh, const ScalarProblem& problem, const ExactSolution& exact,
                       const ScalarField& field, int threads = 0);

}  // namespace anisofront
