// Eigenpairs by the cyclic Jacobi method: C. G. J. Jacobi, J. reine angew. Math. 30 (1846);
// rotation formulas after G. H. Golub and C. F. Van Loan, Matrix Computations, section 8.5.
#include "mesher/metric/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace anisofront {

namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;

constexpr int kMaxSweeps = 30;  // convergence is quadratic, five or six do

Matrix3 identity() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }

/// Turns axes p and q so that the entry (p, q) vanishes; `axes` collects the rotations by columns.
void annihilate(Matrix3& m, Matrix3& axes, std::size_t p, std::size_t q) {
  if (m[p][q] == 0) return;
  const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const double t = std::copysign(1., theta) / (std::fabs(theta) + std::hypot(theta, 1.));
  const double c = 1 / std::hypot(t, 1.), s = t * c;
  const auto turn = [c, s](double& x, double& y) {
    const double old_x = x;
    x = c * old_x - s * y;
    y = s * old_x + c * y;
  };
  for (std::size_t k = 0; k < 3; ++k) turn(m[k][p], m[k][q]);
  for (std::size_t k = 0; k < 3; ++k) turn(m[p][k], m[q][k]);
  for (std::size_t k = 0; k < 3; ++k) turn(axes[k][p], axes[k][q]);
  m[p][q] = m[q][p] = 0;
}

template <class Function>
Metric3 spectral_map(const Metric3& m, Function f) {
  const Eigenpairs3 pairs = eigenpairs(m);
  Metric3 result{0, 0, 0, 0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = f(pairs.values[i]);
    const Vector3& v = pairs.vectors[i];
    result.a += value * v.x * v.x;
    result.b += value * v.x * v.y;
    result.c += value * v.y * v.y;
    result.d += value * v.x * v.z;
    result.e += value * v.y * v.z;
    result.f += value * v.z * v.z;
  }
  return result;
}

}  // namespace

Eigenpairs3 eigenpairs(const Metric3& m) {
  Matrix3 diagonal{{{m.a, m.b, m.d}, {m.b, m.c, m.e}, {m.d, m.e, m.f}}};
  Matrix3 axes = identity();
  const auto is_diagonal = [&] {
    return diagonal[0][1] == 0 && diagonal[0][2] == 0 && diagonal[1][2] == 0;
  };
  for (int sweep = 0; sweep < kMaxSweeps && !is_diagonal(); ++sweep) {
    annihilate(diagonal, axes, 0, 1);
    annihilate(diagonal, axes, 0, 2);
    annihilate(diagonal, axes, 1, 2);
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return diagonal[i][i] > diagonal[j][j]; });
  Eigenpairs3 pairs;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = order[i];
    pairs.values[i] = diagonal[k][k];
    pairs.vectors[i] = {axes[0][k], axes[1][k], axes[2][k]};
  }
  return pairs;
}

bool is_positive_definite(const Metric3& m) {
  for (const double entry : {m.a, m.b, m.c, m.d, m.e, m.f})
    if (!std::isfinite(entry)) return false;
  return eigenpairs(m).values[2] > 0;
}

Metric3 square_root(const Metric3& m) {
  return spectral_map(m, [](double value) { return std::sqrt(value); });  // A3a
}

Metric3 inverse_square_root(const Metric3& m) {
  return spectral_map(m, [](double value) { return 1 / std::sqrt(value); });  // A3b
}

Metric surface_metric(const Vector3& r_u, const Vector3& r_v) {
  return {dot(r_u, r_u), dot(r_u, r_v), dot(r_v, r_v)};  // A7 with ERRATA
}

Metric surface_metric(const Metric3& m, const Vector3& r_u, const Vector3& r_v) {
  return {dot(r_u, m * r_u), dot(r_u, m * r_v), dot(r_v, m * r_v)};  // A9
}

}  // namespace anisofront
