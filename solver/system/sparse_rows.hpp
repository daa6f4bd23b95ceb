#pragma once

#include "solver/system/assemble.hpp"

namespace anisofront {

/// A matrix by rows, columns ascending within each.
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor, Index>;

/// Loops over fewer rows are not worth a second thread.
inline constexpr Eigen::Index kParallelFrom = 10'000;

/// The operations of multigrid, on all cores; results do not depend on their number.
void multiply(const SparseRows& matrix, const Eigen::VectorXd& x, Eigen::VectorXd& result);
/// y += A x.
void add_product(const SparseRows& matrix, const Eigen::VectorXd& x, Eigen::VectorXd& y);
/// b - A x.
void subtract_product(const SparseRows& matrix, const Eigen::VectorXd& x, const Eigen::VectorXd& b,
                      Eigen::VectorXd& result);
SparseRows product(const SparseRows& a, const SparseRows& b);
/// Sums in blocks of fixed size.
double inner_product(const Eigen::VectorXd& x, const Eigen::VectorXd& y);

}  // namespace anisofront
