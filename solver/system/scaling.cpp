#include "solver/system/scaling.hpp"

#include <cmath>
#include <string>

#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

double power_of_two_scale(double diagonal) {
  if (diagonal == 0) return 1;
  // 2^round(-log2(a) / 2): s^2 a lies in [1/2, 2]
  return std::ldexp(1, static_cast<int>(std::lround(-0.5 * std::log2(std::abs(diagonal)))));
}

}  // namespace

Eigen::VectorXd symmetric_scaling(const SparseMatrix& matrix) {
  Eigen::VectorXd scale = matrix.diagonal();
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    if (!std::isfinite(scale[i]))
      throw MeshingError("the diagonal of the matrix is not finite at unknown " +
                         std::to_string(i) + " (counted from 0)");
    scale[i] = power_of_two_scale(scale[i]);
  }
  return scale;
}

double scaled_norm(const SparseMatrix& matrix, const Eigen::VectorXd& scale) {
  double norm = 0;
  for (Index column = 0; column < matrix.cols(); ++column) {
    double sum = 0;
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
      sum += std::abs(entry.value()) * scale[entry.row()];
    norm = std::max(norm, sum * scale[column]);
  }
  return norm;
}

}  // namespace anisofront
