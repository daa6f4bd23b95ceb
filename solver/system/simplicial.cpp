#include <cstdint>
#include <limits>
#include <memory>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include "mesher/geometry/error.hpp"
#include "solver/system/factors.hpp"
#include "solver/system/symbolic.hpp"

namespace anisofront {
namespace {

using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index>;

/// Position of each unknown in the elimination.
Permutation elimination_order(const SparseMatrix& matrix) {
  Permutation inverse;
  Eigen::AMDOrdering<Index>()(matrix.selfadjointView<Eigen::Lower>(), inverse);
  return inverse.inverse();
}

/// The upper triangle of P S A S P'.
SparseMatrix permuted(const SparseMatrix& matrix, const Eigen::VectorXd& scale,
                      const Permutation& order) {
  const SparseMatrix scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
  SparseMatrix upper(matrix.rows(), matrix.cols());
  upper.selfadjointView<Eigen::Upper>() = scaled.selfadjointView<Eigen::Lower>().twistedBy(order);
  return upper;
}

template <class Integer>
using Ldlt = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double, Eigen::ColMajor, Integer>,
                                   Eigen::Upper, Eigen::NaturalOrdering<Integer>>;

template <class Integer>
void require_pivots(const Ldlt<Integer>& ldlt, const Permutation& order) {
  const Eigen::VectorXd pivots = ldlt.vectorD();
  const Permutation unknown_at = order.inverse();
  if (ldlt.info() != Eigen::Success) {  // stopped at the first zero
    const Eigen::VectorXd zero = (pivots.array() == 0).cast<double>();
    Eigen::Index at = 0;
    zero.maxCoeff(&at);
    refuse_pivot(0, unknown_at.indices()[at]);
  }
  Eigen::Index weakest = 0;
  const double least = pivots.minCoeff(&weakest);
  if (!(least > kPivotTolerance * pivots.maxCoeff()))
    refuse_pivot(least, unknown_at.indices()[weakest]);
}

/// With factor indices of type Integer.
template <class Integer>
Factors factorise(const SparseMatrix& upper, const Permutation& order, double nonzeros) {
  const auto ldlt = std::make_shared<Ldlt<Integer>>();
  ldlt->compute(Eigen::SparseMatrix<double, Eigen::ColMajor, Integer>(upper));
  require_pivots<Integer>(*ldlt, order);
  return {"simplicial LDL' (Eigen)", nonzeros, [ldlt, order](Eigen::VectorXd& r, double) {
            r = (order * r).eval();
            r = ldlt->solve(r).eval();
            r = (order.inverse() * r).eval();
          }};
}

}  // namespace

Factors simplicial_factors(const SparseMatrix& matrix, const Eigen::VectorXd& scale,
                           const MemoryLimit& limit) {
  const Permutation order = elimination_order(matrix);
  const SparseMatrix upper = permuted(matrix, scale, order);
  const double nonzeros = factor_nonzeros(upper);
  const bool is_small = nonzeros < std::numeric_limits<Index>::max();
  const double index_bytes = is_small ? sizeof(Index) : sizeof(std::int64_t);
  require_memory(nonzeros * (sizeof(double) + index_bytes), matrix.rows(), limit);
  return is_small ? factorise<Index>(upper, order, nonzeros)
                  : factorise<std::int64_t>(upper, order, nonzeros);
}

}  // namespace anisofront
