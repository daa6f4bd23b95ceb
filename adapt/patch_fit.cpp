#include "adapt/patch_fit.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {
namespace {

/// Of a pivot to its diagonal entry: the share of a term's square that earlier terms leave over.
constexpr double kDependent = 1e-9;

}  // namespace

PatchFrame patch_frame(Point near, const PatchMoments& m) {
  const double share = 1. / m.count;
  const Vector mean = share * m.sum;
  const double xx = share * m.xx - mean.x * mean.x, xy = share * m.xy - mean.x * mean.y,
               yy = share * m.yy - mean.y * mean.y;
  const double l11 = std::sqrt(xx), l21 = xy / l11;
  return {near + mean, l11, l21, std::sqrt(yy - l21 * l21)};
}

PatchPolynomial in_frame(const PatchFrame& frame, const PatchPolynomial& polynomial) {
  // y = c + A z, A lower triangular as both factors are.
  const PatchFrame& own = polynomial.frame;
  const Vector c = own.coordinates(frame.origin);
  const double a11 = frame.l11 / own.l11, a21 = (frame.l21 - own.l21 * a11) / own.l22,
               a22 = frame.l22 / own.l22;
  PatchPolynomial result{frame, {}};
  for (int k = 0; k < kMaxFluxComponents; ++k) {
    const auto p = [&](int term) { return polynomial.coefficients[term][k]; };
    const double slope_x = p(1) + 2 * p(3) * c.x + p(4) * c.y,
                 slope_y = p(2) + p(4) * c.x + 2 * p(5) * c.y;
    const Terms q{
        p(0) + p(1) * c.x + p(2) * c.y + p(3) * c.x * c.x + p(4) * c.x * c.y + p(5) * c.y * c.y,
        slope_x * a11 + slope_y * a21,
        slope_y * a22,
        p(3) * a11 * a11 + p(4) * a11 * a21 + p(5) * a21 * a21,
        p(4) * a11 * a22 + 2 * p(5) * a21 * a22,
        p(5) * a22 * a22};
    for (int i = 0; i < kMaxTerms; ++i) result.coefficients[i][k] = q[i];
  }
  return result;
}

void PatchPolynomials::set(Index patch, const PatchPolynomial& polynomial) {
  frames_[patch] = polynomial.frame;
  double* to = &coefficients_[place(patch)];
  for (int i = 0; i < terms_; ++i)
    to = std::copy_n(polynomial.coefficients[i].begin(), components_, to);
}

PatchPolynomial PatchPolynomials::operator[](Index patch) const {
  PatchPolynomial result{frames_[patch], {}};
  const double* from = &coefficients_[place(patch)];
  for (int i = 0; i < terms_; ++i, from += components_)
    std::copy_n(from, components_, result.coefficients[i].begin());
  return result;
}

void PatchPolynomials::add_value(Index patch, Point x, double weight, double* result) const {
  const Terms t = terms_at(frames_[patch].coordinates(x));
  const double* from = &coefficients_[place(patch)];
  for (int i = 0; i < terms_; ++i)
    for (int c = 0; c < components_; ++c) result[c] += weight * t[i] * *from++;
}

void PatchFit::add(Point x, double weight, const double* values) {
  const Terms t = terms_at(frame_.coordinates(x));
  for (int i = 0; i < terms_; ++i) {
    const double w = weight * t[i];
    for (int j = 0; j <= i; ++j) matrix_[i][j] += w * t[j];
    for (int c = 0; c < components_; ++c) rhs_[i][c] += w * values[c];
  }
}

PatchFit::Factors PatchFit::factors(double tolerance) const {
  Factors f;
  for (int j = 0; j < terms_; ++j) {
    double pivot = matrix_[j][j];
    for (int k = 0; k < j; ++k) pivot -= f.lower[j][k] * f.lower[j][k] * f.pivots[k];
    if (!(pivot > tolerance * matrix_[j][j])) continue;
    f.pivots[j] = pivot;
    for (int i = j + 1; i < terms_; ++i) {
      double entry = matrix_[i][j];
      for (int k = 0; k < j; ++k) entry -= f.lower[i][k] * f.lower[j][k] * f.pivots[k];
      f.lower[i][j] = entry / pivot;
    }
  }
  return f;
}

int PatchFit::independent_terms(double tolerance) const {
  const Factors f = factors(tolerance);
  int count = 0;
  for (int i = 0; i < terms_; ++i) count += f.pivots[i] > 0;
  return count;
}

PatchPolynomial PatchFit::solve() const {
  const Factors f = factors(kDependent);
  PatchPolynomial result{frame_, rhs_};
  auto& x = result.coefficients;
  for (int c = 0; c < components_; ++c) {
    for (int i = 0; i < terms_; ++i)
      for (int k = 0; k < i; ++k) x[i][c] -= f.lower[i][k] * x[k][c];
    for (int i = terms_ - 1; i >= 0; --i) {
      x[i][c] = f.pivots[i] > 0 ? x[i][c] / f.pivots[i] : 0;
      for (int k = i + 1; k < terms_; ++k) x[i][c] -= f.lower[k][i] * x[k][c];
    }
  }
  return result;
}

}  // namespace anisofront
