#include "solver/system/aggregation.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {
namespace {

/// Steps of the power method, and what its estimate lies below the eigenvalue at most.
constexpr int kPowerSteps = 10;
constexpr double kPowerMargin = 1.1;

/// Largest eigenvalue of D^-1 A; the start is arbitrary but fixed.
double largest_eigenvalue(const SparseRows& matrix, const Eigen::VectorXd& inverse_diagonal) {
  Eigen::VectorXd x(matrix.rows()), y;
  for (Eigen::Index i = 0; i < x.size(); ++i)
    x[i] = std::sin(static_cast<double>(1 + i * 7919 % 104729));
  double eigenvalue = 1;
  for (int step = 0; step < kPowerSteps; ++step) {
    x /= std::sqrt(inner_product(x, x));
    multiply(matrix, x, y);
    x = inverse_diagonal.cwiseProduct(y);
    eigenvalue = std::sqrt(inner_product(x, x));
  }
  return kPowerMargin * eigenvalue;
}

/// The diagonal is not lumped to less than this share of what it was.
constexpr double kLeastLumped = 0.1;

class Aggregation {
 public:
  explicit Aggregation(const SparseRows& filtered)
      : matrix_(filtered), result_{std::vector<Index>(filtered.rows(), kNoIndex), 0} {}

  Aggregates run() {
    for (Index i = 0; i < matrix_.rows(); ++i)
      if (is_coupled(i) && is_free_with_neighbours(i)) start_at(i);
    join_strongest();
    for (Index i = 0; i < matrix_.rows(); ++i)
      if (is_free(i) && is_coupled(i)) start_at(i);
    return std::move(result_);
  }

 private:
  bool is_free(Eigen::Index i) const { return result_.of_unknown[i] == kNoIndex; }
  bool is_coupled(Index i) const {
    return matrix_.outerIndexPtr()[i + 1] - matrix_.outerIndexPtr()[i] > 1;
  }
  bool is_free_with_neighbours(Index i) const {
    for (SparseRows::InnerIterator entry(matrix_, i); entry; ++entry)
      if (!is_free(entry.col())) return false;
    return true;
  }
  void start_at(Index i) {
    for (SparseRows::InnerIterator entry(matrix_, i); entry; ++entry)
      if (is_free(entry.col())) result_.of_unknown[entry.col()] = result_.count;
    ++result_.count;
  }
  /// The free ones join the aggregate of the strongest neighbour that had one before.
  void join_strongest() {
    const std::vector<Index> before = result_.of_unknown;
    for (Index i = 0; i < matrix_.rows(); ++i) {
      if (before[i] != kNoIndex) continue;
      double strongest = 0;
      for (SparseRows::InnerIterator entry(matrix_, i); entry; ++entry) {
        if (before[entry.col()] == kNoIndex || std::abs(entry.value()) <= strongest) continue;
        strongest = std::abs(entry.value());
        result_.of_unknown[i] = before[entry.col()];
      }
    }
  }

  const SparseRows& matrix_;
  Aggregates result_;
};

/// The largest -a_ij of each row.
Eigen::VectorXd largest_couplings(const SparseRows& matrix) {
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(matrix.rows());
#pragma omp parallel for schedule(static) if (matrix.rows() >= kParallelFrom)
  for (Index row = 0; row < matrix.rows(); ++row)
    for (SparseRows::InnerIterator entry(matrix, row); entry; ++entry)
      if (entry.col() != row) largest[row] = std::max(largest[row], -entry.value());
  return largest;
}

/// One 1 per row that belongs to an aggregate.
SparseRows tentative_prolongation(const Aggregates& aggregates) {
  const auto rows = static_cast<Index>(aggregates.of_unknown.size());
  SparseRows result(rows, aggregates.count);
  result.reserve(rows);
  for (Index i = 0; i < rows; ++i) {
    result.startVec(i);
    if (aggregates.of_unknown[i] != kNoIndex) result.insertBack(i, aggregates.of_unknown[i]) = 1;
  }
  result.finalize();
  return result;
}

}  // namespace

SparseRows filtered_matrix(const SparseRows& matrix, double strength) {
  const Eigen::VectorXd least = strength * largest_couplings(matrix);
  SparseRows result(matrix.rows(), matrix.cols());
  result.reserve(matrix.nonZeros());
  for (Index row = 0; row < matrix.rows(); ++row) {
    result.startVec(row);
    double lumped = 0;
    double* diagonal = nullptr;
    for (SparseRows::InnerIterator entry(matrix, row); entry; ++entry) {
      const bool is_strong =
          entry.value() < 0 && -entry.value() >= std::min(least[row], least[entry.col()]);
      if (entry.col() == row)
        diagonal = &(result.insertBack(row, row) = entry.value());
      else if (is_strong)
        result.insertBack(row, entry.col()) = entry.value();
      else
        lumped += entry.value();
    }
    if (diagonal && *diagonal + lumped > kLeastLumped * *diagonal) *diagonal += lumped;
  }
  result.finalize();
  return result;
}

Aggregates aggregate(const SparseRows& filtered) { return Aggregation(filtered).run(); }

SparseRows smoothed_prolongation(const SparseRows& filtered, const Aggregates& aggregates) {
  const Eigen::VectorXd inverse = filtered.diagonal().cwiseInverse();
  const double omega = 4. / 3 / largest_eigenvalue(filtered, inverse);
  SparseRows smoother = filtered;  // I - omega D^-1 A_F
  for (Index row = 0; row < smoother.rows(); ++row)
    for (SparseRows::InnerIterator entry(smoother, row); entry; ++entry)
      entry.valueRef() = (entry.col() == row ? 1. : 0.) - omega * inverse[row] * entry.value();
  return product(smoother, tentative_prolongation(aggregates));
}

}  // namespace anisofront
