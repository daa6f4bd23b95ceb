#include "mesher/metric/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace anisofront {

namespace {

Vector swapped(Vector v) { return {v.y, v.x}; }
Metric swapped(const Metric& m) { return {m.m22, m.m12, m.m11}; }

/// Reduction through G = R1 R2^-1 with M = R'R: singular values of G squared are the eigenvalues
/// lambda of M1 relative to M2. Forming G before squaring halves the digits lost at high stretch.
SimultaneousReduction reduce(const MetricFactor& r1, const MetricFactor& r2) {
  const double g11 = r1.a / r2.a, g22 = r1.c / r2.c;
  const double g12 = (r1.b - g11 * r2.b) / r2.c;
  // Eigenproblem of G'G; its determinant is the square of g11 g22, without cancellation.
  const double b11 = g11 * g11, b12 = g11 * g12, b22 = g12 * g12 + g22 * g22;
  const double half_difference = 0.5 * (b11 - b22);
  const double radius = std::sqrt(half_difference * half_difference + b12 * b12);
  const double largest = 0.5 * (b11 + b22) + radius;
  Vector q{1, 0};
  if (radius > 0)
    q = half_difference >= 0 ? Vector{half_difference + radius, b12}
                             : Vector{b12, radius - half_difference};
  q = (1 / norm(q)) * q;
  const auto solve = [&r2](Vector x) {
    const double y = x.y / r2.c;
    return Vector{(x.x - r2.b * y) / r2.a, y};
  };
  const double product = g11 * g22;
  return {solve(q), solve({-q.y, q.x}), largest, product * product / largest, 1, 1};
}

/// Weighted mean of size tensors or of logarithms (weights sum to 1).
template <std::size_t N>
Metric mean(Interpolation method, const std::array<Metric, N>& m,
            const std::array<double, N>& weight) {
  SizeTensor size{0, 0, 0};
  Metric log{0, 0, 0};
  for (std::size_t i = 0; i < N; ++i) {
    if (method == Interpolation::linear_size) {
      const SizeTensor h = size_of(m[i]);
      size.h11 += weight[i] * h.h11;
      size.h12 += weight[i] * h.h12;
      size.h22 += weight[i] * h.h22;
    } else {
      const Metric l = logarithm(m[i]);
      log.m11 += weight[i] * l.m11;
      log.m12 += weight[i] * l.m12;
      log.m22 += weight[i] * l.m22;
    }
  }
  return method == Interpolation::linear_size ? metric_of(size) : exponential(log);
}

Metric interpolate_reduced(const Metric& m1, const Metric& m2, double t) {
  if (t <= 0) return m1;
  if (t >= 1) return m2;
  const SimultaneousReduction r = simultaneous_reduction(m1, m2);
  const auto size = [t](double lambda, double mu) {
    const double r1 = 1 / std::sqrt(lambda), w1 = 1 / std::sqrt(mu);  // Eqn 5
    return r1 + t * (w1 - r1);                                        // Eqn 6 with ERRATA
  };
  const double h1 = size(r.lambda1, r.mu1), h2 = size(r.lambda2, r.mu2);
  return metric_from_reduction(r.s1, r.s2, 1 / (h1 * h1), 1 / (h2 * h2));  // Eqn 7
}

/// sum of f(lambda_i) e_i e_i' for a symmetric tensor that need not be positive.
template <class Function>
Metric spectral_map(const Metric& m, Function f) {
  const double centre = 0.5 * (m.m11 + m.m22), half_difference = 0.5 * (m.m11 - m.m22);
  const double radius = std::sqrt(half_difference * half_difference + m.m12 * m.m12);
  const double f1 = f(centre + radius, true), f2 = f(centre - radius, false);
  const double cosine = radius > 0 ? half_difference / radius : 1;
  const double sine = radius > 0 ? m.m12 / radius : 0;
  const double mid = 0.5 * (f1 + f2), half = 0.5 * (f1 - f2);
  return {mid + half * cosine, half * sine, mid - half * cosine};
}

}  // namespace

SimultaneousReduction simultaneous_reduction(const Metric& m1, const Metric& m2) {
  if (m2.m11 >= m2.m22) return reduce(factor_of(m1), factor_of(m2));
  // Pivoting: the larger diagonal entry first keeps the rows of R2 graded.
  SimultaneousReduction r = reduce(factor_of(swapped(m1)), factor_of(swapped(m2)));
  r.s1 = swapped(r.s1);
  r.s2 = swapped(r.s2);
  return r;
}

Metric metric_from_reduction(Vector s1, Vector s2, double q1, double q2) {
  // The rows of S^-1: w1 is normal to s2, w2 to s1.
  const double inverse_det = 1 / cross(s1, s2);
  const Vector w1{s2.y * inverse_det, -s2.x * inverse_det};
  const Vector w2{-s1.y * inverse_det, s1.x * inverse_det};
  return {q1 * w1.x * w1.x + q2 * w2.x * w2.x, q1 * w1.x * w1.y + q2 * w2.x * w2.y,
          q1 * w1.y * w1.y + q2 * w2.y * w2.y};
}

Metric interpolate(Interpolation method, const Metric& m1, const Metric& m2, double t) {
  if (method == Interpolation::simultaneous_reduction) return interpolate_reduced(m1, m2, t);
  if (t <= 0) return m1;
  if (t >= 1) return m2;
  return mean<2>(method, {m1, m2}, {1 - t, t});
}

Metric interpolate(Interpolation method, const std::array<Metric, 3>& m,
                   const std::array<double, 3>& barycentric) {
  if (method != Interpolation::simultaneous_reduction) return mean<3>(method, m, barycentric);
  std::size_t last = 0;  // the vertex that is reached second
  for (std::size_t i = 1; i < 3; ++i)
    if (determinant(m[i]) > determinant(m[last])) last = i;
  const std::size_t i = (last + 1) % 3, j = (last + 2) % 3;
  const double on_edge = barycentric[i] + barycentric[j];
  if (on_edge <= 0) return m[last];
  const Metric q1 = interpolate_reduced(m[i], m[j], barycentric[j] / on_edge);  // Fig. 2a
  return interpolate_reduced(m[last], q1, on_edge);
}

Metric interpolate(Interpolation method, const std::array<Metric, 4>& m, double xi, double eta) {
  if (method != Interpolation::simultaneous_reduction)
    return mean<4>(method, m, {(1 - xi) * (1 - eta), xi * (1 - eta), xi * eta, (1 - xi) * eta});
  const Metric q1 = interpolate_reduced(m[0], m[1], xi);  // Fig. 2b
  const Metric q2 = interpolate_reduced(m[3], m[2], xi);
  return interpolate_reduced(q1, q2, eta);
}

std::array<double, 2> bilinear_coordinates(const std::array<Point, 4>& quad, Point p) {
  // p = a + xi e + eta f + xi eta g; eliminating xi leaves k2 eta^2 + k1 eta + k0 = 0, whose
  // derivative at the wanted root is the Jacobian of the map, hence the positive square root.
  const Vector e = quad[1] - quad[0], f = quad[3] - quad[0];
  const Vector g = quad[2] - quad[1] - f, h = p - quad[0];
  const double k0 = cross(h, e), k1 = cross(e, f) + cross(h, g), k2 = cross(g, f);
  const double root = std::sqrt(std::max(0., k1 * k1 - 4 * k0 * k2));
  double eta = k1 >= 0 ? -2 * k0 / (k1 + root) : (root - k1) / (2 * k2);
  eta = std::isfinite(eta) ? std::clamp(eta, 0., 1.) : 0;
  const Vector along = e + eta * g;
  const double xi = dot(h - eta * f, along) / squared_norm(along);
  return {std::isfinite(xi) ? std::clamp(xi, 0., 1.) : 0, eta};
}

Metric logarithm(const Metric& m) {
  const double det = determinant(m);
  double largest = 1;  // the smaller eigenvalue is det over the larger one, without cancellation
  return spectral_map(m, [&](double lambda, bool first) {
    if (first) largest = lambda;
    return std::log(first ? lambda : det / largest);
  });
}

Metric exponential(const Metric& log_m) {
  return spectral_map(log_m, [](double lambda, bool) { return std::exp(lambda); });
}

}  // namespace anisofront
