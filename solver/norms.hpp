#pragma once

#include <span>

#include "mesher/mesh/mesh.hpp"
#include "solver/exact_solutions.hpp"
#include "solver/scalar_problem.hpp"

namespace anisofront {

/// Norms of the error of a P1 function, e = u - u_h, and of the exact solution.
struct ErrorNorms {
  double l2 = 0;            ///< sqrt(int e^2)
  double h1 = 0;            ///< sqrt(int |grad e|^2)
  double energy = 0;        ///< sqrt(int a |grad e|^2 + c e^2)
  double exact_energy = 0;  ///< sqrt(int a |grad u|^2 + c u^2)
  double relative_energy() const { return energy / exact_energy; }
};

/// Quadrature of degree 8, with triangles subdivided where u is far from linear or where rules of
/// different degree disagree: the norms are accurate to about 1e-4 relative even when a layer of
/// the exact solution lies inside one element. `values`: one per vertex.
ErrorNorms error_norms(const Mesh& mesh, const ScalarProblem& problem, const ExactSolution& exact,
                       std::span<const double> values);

}  // namespace anisofront
