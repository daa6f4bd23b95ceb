#include "solver/linear_solve.hpp"

#include <string>

#include <Eigen/SparseCholesky>

#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

using Factorisation = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>>;

/// Pivots below this share of the largest are rounding: a mechanism that nothing holds.
constexpr double kPivotTolerance = 1e-14;

void require_pivots(const Factorisation& factors) {
  const Eigen::VectorXd pivots = factors.vectorD();
  Eigen::Index weakest = 0;
  const double least = pivots.minCoeff(&weakest);
  if (least > kPivotTolerance * pivots.maxCoeff()) return;
  const auto unknown = factors.permutationPinv().indices()[weakest];
  throw MeshingError("the linear system is singular or indefinite: pivot " + std::to_string(least) +
                     " at unknown " + std::to_string(unknown + 1) +
                     "; some part of the model is held by no boundary condition and no reaction");
}

}  // namespace

Eigen::VectorXd solve_positive_definite(const LinearSystem& system) {
  const Factorisation factors(system.matrix);
  if (factors.info() != Eigen::Success)
    throw MeshingError("the LDL' factorisation of the linear system failed on a zero pivot (" +
                       std::to_string(system.matrix.rows()) +
                       " unknowns); some part of the model is held by no boundary condition and no"
                       " reaction");
  require_pivots(factors);
  const Eigen::VectorXd solution = factors.solve(system.rhs);
  if (!solution.allFinite())
    throw MeshingError(
        "the solution of the linear system is not finite although the matrix could"
        " be factorised; check the source and the boundary values");
  return solution;
}

}  // namespace anisofront
