#include <memory>

#include <Eigen/SparseLU>

#include "mesher/geometry/error.hpp"
#include "solver/system/factors.hpp"

namespace anisofront {
namespace {

using SparseLu = Eigen::SparseLU<SparseMatrix, Eigen::COLAMDOrdering<Index>>;

}  // namespace

// Eigen cannot tell the size of the factors before it computes them: the limit is not used.
Factors general_factors(const SparseMatrix& matrix, const Eigen::VectorXd& scale,
                        const MemoryLimit& /*limit*/) {
  const auto lu = std::make_shared<SparseLu>();
  lu->compute(scale.asDiagonal() * matrix * scale.asDiagonal());
  if (lu->info() != Eigen::Success)
    throw MeshingError("the matrix of " + std::to_string(matrix.cols()) +
                       " unknowns is singular: " + lu->lastErrorMessage());
  const double nonzeros = static_cast<double>(lu->nnzL() + lu->nnzU());
  return {"sparse LU (Eigen)", nonzeros,
          [lu](Eigen::VectorXd& r, double) { r = lu->solve(r).eval(); }};
}

}  // namespace anisofront
