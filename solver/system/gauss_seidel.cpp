#include "solver/system/gauss_seidel.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {
namespace {

constexpr Index kMostBlocks = 64;
constexpr Index kRowsPerBlock = 4096;

}  // namespace

GaussSeidel::GaussSeidel(const SparseRows& matrix)
    : matrix_(matrix),
      blocks_(std::clamp<Index>(static_cast<Index>(matrix.rows()) / kRowsPerBlock, 1, kMostBlocks)),
      inverse_diagonal_(matrix.rows()) {
#pragma omp parallel for schedule(static) if (blocks_ > 1)
  for (Index block = 0; block < blocks_; ++block) {
    const Index begin = block_begin(block), end = block_begin(block + 1);
    for (Index row = begin; row < end; ++row) {
      double diagonal = 0;
      for (SparseRows::InnerIterator entry(matrix_, row); entry; ++entry) {
        const bool is_inside = entry.col() >= begin && entry.col() < end;
        if (entry.col() == row) diagonal += entry.value();
        if (!is_inside) diagonal += std::abs(entry.value());
      }
      inverse_diagonal_[row] = 1 / diagonal;
    }
  }
}

Index GaussSeidel::block_begin(Index block) const {
  return static_cast<Index>(static_cast<std::int64_t>(matrix_.rows()) * block / blocks_);
}

void GaussSeidel::forward_from_zero(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  x.resize(b.size());
  const Index* outer = matrix_.outerIndexPtr();
  const Index* columns = matrix_.innerIndexPtr();
  const double* values = matrix_.valuePtr();
#pragma omp parallel for schedule(static) if (blocks_ > 1)
  for (Index block = 0; block < blocks_; ++block) {
    const Index begin = block_begin(block);
    for (Index row = begin; row < block_begin(block + 1); ++row) {
      double sum = b[row];
      for (Index k = outer[row]; columns[k] < row; ++k)
        if (columns[k] >= begin) sum -= values[k] * x[columns[k]];
      x[row] = sum * inverse_diagonal_[row];
    }
  }
}

void GaussSeidel::backward(const Eigen::VectorXd& b, Eigen::VectorXd& x,
                           Eigen::VectorXd& work) const {
  const Index* outer = matrix_.outerIndexPtr();
  const Index* columns = matrix_.innerIndexPtr();
  const double* values = matrix_.valuePtr();
#pragma omp parallel for schedule(static) if (blocks_ > 1)
  for (Index block = 0; block < blocks_; ++block) {
    const Index begin = block_begin(block), end = block_begin(block + 1);
    for (Index row = end; row-- > begin;) {
      double sum = b[row];
      for (Index k = outer[row]; k < outer[row + 1]; ++k) {
        const bool is_inside = columns[k] >= begin && columns[k] < end;
        sum -= values[k] * (is_inside ? x : work)[columns[k]];
      }
      x[row] += sum * inverse_diagonal_[row];
    }
  }
}

}  // namespace anisofront
