#include "mesher/metric/quality.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/metric/metric_length.hpp"

namespace anisofront {

namespace {

template <std::size_t N>
std::array<MetricFactor, N> factors(const std::array<Metric, N>& m) {
  std::array<MetricFactor, N> result;
  std::transform(m.begin(), m.end(), result.begin(),
                 [](const Metric& metric) { return factor_of(metric); });
  return result;
}

template <std::size_t N>
double mu_of(double shape, const std::array<Metric, N>& m, const std::array<Point, N>& p) {
  std::array<double, N> lengths;
  for (std::size_t i = 0; i < N; ++i) {
    const std::size_t j = (i + 1) % N;
    const Vector edge = p[j] - p[i];
    lengths[i] = trapezoid_length(squared_length(m[i], edge), squared_length(m[j], edge));
  }
  return mu(shape, lengths);
}

}  // namespace

double alpha(const std::array<MetricFactor, 3>& m, const std::array<Point, 3>& p) {
  return std::min({alpha(m[0], p[0], p[1], p[2]), alpha(m[1], p[0], p[1], p[2]),
                   alpha(m[2], p[0], p[1], p[2])});  // Eqn 15a
}

double alpha(const std::array<Metric, 3>& m, const std::array<Point, 3>& p) {
  return alpha(factors(m), p);
}

double beta(const std::array<MetricFactor, 4>& m, const std::array<Point, 4>& p) {
  constexpr std::size_t kTriangles[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};
  std::array<double, 4> a;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [j, k, l] = kTriangles[i];
    a[i] = alpha(std::array{m[j], m[k], m[l]}, std::array{p[j], p[k], p[l]});
  }
  std::sort(a.begin(), a.end());                       // Eqn 16a, ascending here
  return a[0] > 0 ? a[0] * a[1] / (a[2] * a[3]) : -1;  // Eqn 16b
}

double beta(const std::array<Metric, 4>& m, const std::array<Point, 4>& p) {
  return beta(factors(m), p);
}

double mu(double shape, std::span<const double> lengths) {
  double delta = 0;
  for (const double l : lengths) delta += std::fabs(l - 1);
  return shape * std::exp(-delta / static_cast<double>(lengths.size()));  // Eqns 17a, 17b
}

double mu(const std::array<Metric, 3>& m, const std::array<Point, 3>& p) {
  return mu_of(alpha(m, p), m, p);
}

double mu(const std::array<Metric, 4>& m, const std::array<Point, 4>& p) {
  return mu_of(beta(m, p), m, p);
}

}  // namespace anisofront
