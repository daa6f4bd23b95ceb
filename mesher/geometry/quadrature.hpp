#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace anisofront::detail {

/// Gauss-Legendre rule with eight points on [a, b]: exact for polynomials up to degree 15.
template <class Function>
double gauss_8(const Function& f, double a, double b) {
  constexpr std::array<double, 4> kNodes{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                         0.9602898564975363};
  constexpr std::array<double, 4> kWeights{0.3626837833783620, 0.3137066458778873,
                                           0.2223810344533745, 0.1012285362903763};
  const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
  double sum = 0;
  for (std::size_t i = 0; i < kNodes.size(); ++i)
    sum += kWeights[i] * (f(middle - half * kNodes[i]) + f(middle + half * kNodes[i]));
  return half * sum;
}

/// Integral of f over [a, b]: halved until both halves together agree with the whole to
/// `tolerance` (absolute), at most `depth` times: the bound on the work where rounding is larger
/// than the tolerance. `whole` is gauss_8(f, a, b).
template <class Function>
double integrate(const Function& f, double a, double b, double tolerance, double whole,
                 int depth = 12) {
  const double middle = 0.5 * (a + b);
  const double left = gauss_8(f, a, middle), right = gauss_8(f, middle, b);
  if (depth == 0 || std::fabs(left + right - whole) <= tolerance) return left + right;
  return integrate(f, a, middle, 0.5 * tolerance, left, depth - 1) +
         integrate(f, middle, b, 0.5 * tolerance, right, depth - 1);
}

}  // namespace anisofront::detail
