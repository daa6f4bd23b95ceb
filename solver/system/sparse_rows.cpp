#include "solver/system/sparse_rows.hpp"

#include <algorithm>

namespace anisofront {
namespace {

constexpr Eigen::Index kSumBlock = 8192;

double row_times(const SparseRows& matrix, Index row, const double* x) {
  const Index* columns = matrix.innerIndexPtr();
  const double* values = matrix.valuePtr();
  const Index* outer = matrix.outerIndexPtr();
  double sum = 0;
  for (Index k = outer[row]; k < outer[row + 1]; ++k) sum += values[k] * x[columns[k]];
  return sum;
}

/// One row of a product at a time, in a dense accumulator.
class RowProduct {
 public:
  RowProduct(const SparseRows& a, const SparseRows& b)
      : a_(a), b_(b), marked_(b.cols(), kNoIndex), sum_(b.cols()) {}

  /// Columns of the row, ascending.
  const std::vector<Index>& columns(Index row) {
    columns_.clear();
    for (SparseRows::InnerIterator outer(a_, row); outer; ++outer)
      for (SparseRows::InnerIterator inner(b_, outer.col()); inner; ++inner) {
        const auto column = static_cast<Index>(inner.col());
        if (marked_[column] == row) continue;
        marked_[column] = row;
        sum_[column] = 0;
        columns_.push_back(column);
      }
    return columns_;
  }

  void fill(Index row, Index* columns_out, double* values_out) {
    columns(row);
    std::sort(columns_.begin(), columns_.end());
    for (SparseRows::InnerIterator outer(a_, row); outer; ++outer)
      for (SparseRows::InnerIterator inner(b_, outer.col()); inner; ++inner)
        sum_[inner.col()] += outer.value() * inner.value();
    for (const Index column : columns_) {
      *columns_out++ = column;
      *values_out++ = sum_[column];
    }
  }

  void forget_marks() { std::fill(marked_.begin(), marked_.end(), kNoIndex); }

 private:
  const SparseRows& a_;
  const SparseRows& b_;
  std::vector<Index> marked_;
  std::vector<double> sum_;
  std::vector<Index> columns_;
};

}  // namespace

void multiply(const SparseRows& matrix, const Eigen::VectorXd& x, Eigen::VectorXd& result) {
  result.resize(matrix.rows());
#pragma omp parallel for schedule(static) if (matrix.rows() >= kParallelFrom)
  for (Index row = 0; row < matrix.rows(); ++row) result[row] = row_times(matrix, row, x.data());
}

void add_product(const SparseRows& matrix, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
#pragma omp parallel for schedule(static) if (matrix.rows() >= kParallelFrom)
  for (Index row = 0; row < matrix.rows(); ++row) y[row] += row_times(matrix, row, x.data());
}

void subtract_product(const SparseRows& matrix, const Eigen::VectorXd& x, const Eigen::VectorXd& b,
                      Eigen::VectorXd& result) {
  result.resize(matrix.rows());
#pragma omp parallel for schedule(static) if (matrix.rows() >= kParallelFrom)
  for (Index row = 0; row < matrix.rows(); ++row)
    result[row] = b[row] - row_times(matrix, row, x.data());
}

SparseRows product(const SparseRows& a, const SparseRows& b) {
  SparseRows result(a.rows(), b.cols());
  Index* outer = result.outerIndexPtr();
#pragma omp parallel if (a.rows() >= kParallelFrom)
  {
    RowProduct work(a, b);
#pragma omp for schedule(static)
    for (Index row = 0; row < a.rows(); ++row)
      outer[row + 1] = static_cast<Index>(work.columns(row).size());
#pragma omp single
    {
      for (Index row = 0; row < a.rows(); ++row) outer[row + 1] += outer[row];
      result.resizeNonZeros(outer[a.rows()]);
    }
    work.forget_marks();
#pragma omp for schedule(static)
    for (Index row = 0; row < a.rows(); ++row)
      work.fill(row, result.innerIndexPtr() + outer[row], result.valuePtr() + outer[row]);
  }
  return result;
}

double inner_product(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  const Eigen::Index blocks = (x.size() + kSumBlock - 1) / kSumBlock;
  std::vector<double> sums(blocks);
#pragma omp parallel for schedule(static) if (x.size() >= kParallelFrom)
  for (Eigen::Index b = 0; b < blocks; ++b) {
    const Eigen::Index begin = b * kSumBlock;
    const Eigen::Index size = std::min(kSumBlock, x.size() - begin);
    sums[b] = x.segment(begin, size).dot(y.segment(begin, size));
  }
  double sum = 0;
  for (const double s : sums) sum += s;
  return sum;
}

}  // namespace anisofront
