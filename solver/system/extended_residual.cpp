#include "solver/system/extended_residual.hpp"

#include <cmath>

namespace anisofront {
namespace {

/// Loops over fewer rows are not worth a second thread.
constexpr Eigen::Index kParallelFrom = 10'000;

/// A running sum with the rounding errors of all its additions and products.
struct CompensatedSum {
  double sum = 0;
  double error = 0;

  void add(double value) {
    const double next = sum + value;  // TwoSum
    const double part = next - sum;
    error += (sum - (next - part)) + (value - part);
    sum = next;
  }
  void add_product(double a, double b) {
    const double product = a * b;  // TwoProduct
    error += std::fma(a, b, -product);
    add(product);
  }
};

}  // namespace

void ExtendedVector::add(const Eigen::VectorXd& step) {
  for (Eigen::Index i = 0; i < high.size(); ++i) {
    CompensatedSum sum{high[i], low[i]};
    sum.add(step[i]);
    high[i] = sum.sum + sum.error;
    low[i] = sum.error - (high[i] - sum.sum);
  }
}

Eigen::VectorXd extended_residual(const SparseMatrix& rows, const Eigen::VectorXd& b,
                                  const ExtendedVector& x) {
  Eigen::VectorXd residual(b.size());
#pragma omp parallel for schedule(static) if (rows.cols() >= kParallelFrom)
  for (Index row = 0; row < rows.cols(); ++row) {
    CompensatedSum sum{b[row], 0};
    for (SparseMatrix::InnerIterator entry(rows, row); entry; ++entry) {
      sum.add_product(-entry.value(), x.high[entry.row()]);
      sum.error -= entry.value() * x.low[entry.row()];
    }
    residual[row] = sum.sum + sum.error;
  }
  return residual;
}

}  // namespace anisofront
