#include "solver/system/factors.hpp"

// Takes the place of cholmod.cpp in builds without SuiteSparse.
namespace anisofront {

Factors supernodal_factors(const SparseMatrix& matrix, const Eigen::VectorXd& scale,
                           const MemoryLimit& limit) {
  return simplicial_factors(matrix, scale, limit);
}

}  // namespace anisofront
