#pragma once

#include <random>

#include "solver/system/assemble.hpp"

namespace anisofront {

/// About `per_row` random entries in [-1, 1] in each row, and a zero diagonal.
inline Eigen::MatrixXd random_entries(int unknowns, int per_row, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  std::uniform_int_distribution<int> column(0, unknowns - 1);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(unknowns, unknowns);
  for (int row = 0; row < unknowns; ++row)
    for (int k = 0; k < per_row; ++k) matrix(row, column(generator)) = value(generator);
  matrix.diagonal().setZero();
  return matrix;
}

/// Symmetric, diagonally dominant by 0.1.
inline Eigen::MatrixXd random_positive_definite(int unknowns, unsigned seed) {
  const Eigen::MatrixXd half = random_entries(unknowns, 2, seed);
  Eigen::MatrixXd matrix = half + half.transpose();
  matrix.diagonal() = matrix.cwiseAbs().rowwise().sum().array() + 0.1;
  return matrix;
}

/// A symmetric pattern with values that are not, as convection makes them.
inline Eigen::MatrixXd random_unsymmetric(int unknowns, unsigned seed) {
  Eigen::MatrixXd matrix = random_positive_definite(unknowns, seed);
  matrix.triangularView<Eigen::StrictlyUpper>() *= 0.25;
  return matrix;
}

inline LinearSystem sparse_system(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs) {
  return {matrix.sparseView(), rhs};
}

/// Right-hand side 1, 2, 3, 1, 2, ...: no symmetry and no zero.
inline Eigen::VectorXd sample_load(Eigen::Index size) {
  return Eigen::VectorXd::NullaryExpr(size, [](Eigen::Index i) { return 1. + double(i % 3); });
}

/// -d2u/dx2 - stretch d2u/dy2 by five-point differences on n x n inner points of a square.
inline SparseMatrix difference_laplacian(int n, double stretch) {
  std::vector<Eigen::Triplet<double, Index>> entries;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int i = y * n + x;
      entries.emplace_back(i, i, 2 + 2 * stretch);
      if (x > 0) entries.emplace_back(i, i - 1, -1.);
      if (x + 1 < n) entries.emplace_back(i, i + 1, -1.);
      if (y > 0) entries.emplace_back(i, i - n, -stretch);
      if (y + 1 < n) entries.emplace_back(i, i + n, -stretch);
    }
  SparseMatrix matrix(n * n, n * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace anisofront
