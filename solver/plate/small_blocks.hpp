#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Dense>

#include "mesher/geometry/point.hpp"

namespace anisofront {

// Plain loops over small matrices of fixed size: the compiler vectorises them, and they compile in
// a fraction of the time that expressions of Eigen take for each size.

template <int Rows, int Columns>
using Block = Eigen::Matrix<double, Rows, Columns>;

/// A B.
template <int N, int K, int M>
Block<N, M> product(const Block<N, K>& a, const Block<K, M>& b) {
  Block<N, M> result;
  for (int j = 0; j < M; ++j) {
    for (int i = 0; i < N; ++i) result(i, j) = a(i, 0) * b(0, j);
    for (int k = 1; k < K; ++k)
      for (int i = 0; i < N; ++i) result(i, j) += a(i, k) * b(k, j);
  }
  return result;
}

/// Adds weight A B'.
template <int N, int M, int K>
void add_product(double weight, const Block<N, K>& a, const Block<M, K>& b, Block<N, M>& sum) {
  for (int j = 0; j < M; ++j)
    for (int i = 0; i < N; ++i) {
      double value = 0;
      for (int k = 0; k < K; ++k) value += weight * b(j, k) * a(i, k);
      sum(i, j) += value;
    }
}

/// The sum of factors times blocks.
template <std::size_t K, int N, int M>
Block<N, M> combination(const double (&factors)[K], const Block<N, M>* const (&blocks)[K]) {
  Block<N, M> sum;
  for (int i = 0; i < N * M; ++i) {
    double value = factors[0] * blocks[0]->data()[i];
    for (std::size_t k = 1; k < K; ++k) value += factors[k] * blocks[k]->data()[i];
    sum.data()[i] = value;
  }
  return sum;
}

template <int N>
double dot(const Block<N, 1>& x, const Block<N, 1>& y) {
  double sum = 0;
  for (int i = 0; i < N; ++i) sum += x[i] * y[i];
  return sum;
}

/// The sum of values times rows.
template <int N>
Vector combination(const Block<N, 1>& values, const Block<N, 2>& rows) {
  Vector sum;
  for (int i = 0; i < N; ++i) sum = sum + values[i] * Vector{rows(i, 0), rows(i, 1)};
  return sum;
}

/// x' A y.
template <int N, int M>
double bilinear(const Block<N, 1>& x, const Block<N, M>& a, const Block<M, 1>& y) {
  double sum = 0;
  for (int j = 0; j < M; ++j)
    for (int i = 0; i < N; ++i) sum += x[i] * a(i, j) * y[j];
  return sum;
}

/// Values as a column.
template <std::size_t N>
Block<static_cast<int>(N), 1> as_column(const std::array<double, N>& values) {
  return Block<static_cast<int>(N), 1>(values.data());
}

/// Vectors as rows.
template <std::size_t N>
Block<static_cast<int>(N), 2> as_rows(const std::array<Vector, N>& vectors) {
  Block<static_cast<int>(N), 2> rows;
  for (int i = 0; i < static_cast<int>(N); ++i) {
    rows(i, 0) = vectors[i].x;
    rows(i, 1) = vectors[i].y;
  }
  return rows;
}

}  // namespace anisofront
