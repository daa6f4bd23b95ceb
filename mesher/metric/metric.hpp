#pragma once

#include <cmath>

#include "mesher/geometry/point.hpp"

namespace anisofront {

/// Symmetric positive definite 2x2 tensor [[m11, m12], [m12, m22]], in 1/length^2: the metric of
/// the paper (Eqn 2a with a = m11, b = m12, c = m22). A vector v has length sqrt(v' M v).
struct Metric {
  double m11 = 1;
  double m12 = 0;
  double m22 = 1;
  friend bool operator==(const Metric&, const Metric&) = default;
};

/// The size tensor H = M^(-1/2), in length units, with the same layout.
struct SizeTensor {
  double h11 = 1;
  double h12 = 0;
  double h22 = 1;
};

/// Upper Cholesky factor [[a, b], [0, c]] of a metric, M = R'R. Squared lengths need no
/// subtraction, so they keep their relative accuracy at any stretch.
struct MetricFactor {
  double a = 1;
  double b = 0;
  double c = 1;
};

inline double determinant(const Metric& m) { return m.m11 * m.m22 - m.m12 * m.m12; }

/// Squared length of v in a constant metric (Eqn 10a).
inline double squared_length(const Metric& m, Vector v) {
  return m.m11 * v.x * v.x + 2 * m.m12 * v.x * v.y + m.m22 * v.y * v.y;
}
inline double squared_length(const MetricFactor& r, Vector v) {
  const double s = r.a * v.x + r.b * v.y;
  const double t = r.c * v.y;
  return s * s + t * t;
}
/// Length of v in a constant metric (Eqn 1a with constant M).
inline double length(const Metric& m, Vector v) { return std::sqrt(squared_length(m, v)); }
inline double length(const MetricFactor& r, Vector v) { return std::sqrt(squared_length(r, v)); }

/// M = R'R.
inline Metric metric_of(const MetricFactor& r) {
  return {r.a * r.a, r.a * r.b, r.b * r.b + r.c * r.c};
}

/// Cholesky factor of M; precondition: M is positive definite.
inline MetricFactor factor_of(const Metric& m) {
  const double a = std::sqrt(m.m11);
  const double b = m.m12 / a;
  return {a, b, std::sqrt(m.m22 - b * b)};
}

/// M^(-1/2) (Eqn 14b).
inline SizeTensor size_of(const Metric& m) {
  const double d = std::sqrt(determinant(m));
  const double s = 1 / (d * std::sqrt(m.m11 + m.m22 + 2 * d));
  return {(m.m22 + d) * s, -m.m12 * s, (m.m11 + d) * s};
}

/// Cholesky factor of M = H^(-2), without forming M.
inline MetricFactor factor_of(const SizeTensor& h) {
  const double inverse_det = 1 / (h.h11 * h.h22 - h.h12 * h.h12);
  const double w = std::sqrt(h.h12 * h.h12 + h.h22 * h.h22);
  return {w * inverse_det, -h.h12 * (h.h11 + h.h22) / w * inverse_det, 1 / w};
}

/// M = H^(-2). metric_of(size_of(M)) returns M up to 3e-16 times the stretch h2/h1, relative to the
/// largest entry (measured: 3e-15 at stretch 10, 3e-12 at 1e4).
inline Metric metric_of(const SizeTensor& h) { return metric_of(factor_of(h)); }

inline Vector operator*(const Metric& m, Vector v) {
  return {m.m11 * v.x + m.m12 * v.y, m.m12 * v.x + m.m22 * v.y};
}
inline Vector operator*(const SizeTensor& h, Vector v) {
  return {h.h11 * v.x + h.h12 * v.y, h.h12 * v.x + h.h22 * v.y};
}

/// factor * M: lengths grow by sqrt(factor), sizes shrink by it.
inline Metric scaled(const Metric& m, double factor) {
  return {factor * m.m11, factor * m.m12, factor * m.m22};
}

/// Finite with positive eigenvalues. Relies on det M, so a stretch above about 5e7 may be refused:
/// three doubles do not hold it.
inline bool is_positive_definite(const Metric& m) {
  return std::isfinite(m.m11) && std::isfinite(m.m12) && std::isfinite(m.m22) && m.m11 > 0 &&
         determinant(m) > 0;
}

/// The ellipse of unit length: sizes h1 <= h2 (length units) along the unit vectors e1 and e2;
/// e2 is e1 turned by +90 degrees. M = e1 e1' / h1^2 + e2 e2' / h2^2 (Eqn 2b).
struct PrincipalAxes {
  double h1 = 1, h2 = 1;
  Vector e1{1, 0}, e2{0, 1};
};

/// Eigenpairs of M as sizes and directions (Eqn 2b); the axes (1,0), (0,1) for an isotropic M.
/// Relative accuracy 1e-16 of h1 and e1; of h2 1e-16 (h2/h1)^2, which is what M itself holds.
inline PrincipalAxes principal_axes(const Metric& m) {
  const double half_difference = 0.5 * (m.m11 - m.m22);
  const double radius = std::sqrt(half_difference * half_difference + m.m12 * m.m12);
  const double largest = 0.5 * (m.m11 + m.m22) + radius;
  Vector e1{1, 0};
  if (radius > 0)  // of two parallel eigenvectors the one without cancellation
    e1 = half_difference >= 0 ? Vector{half_difference + radius, m.m12}
                              : Vector{m.m12, radius - half_difference};
  e1 = (1 / norm(e1)) * e1;
  return {1 / std::sqrt(largest), std::sqrt(largest / determinant(m)), e1, {-e1.y, e1.x}};
}

/// Metric with size h1 along e1 and h2 across it (Eqns 2b and 3). Preconditions: h1, h2 > 0 and
/// e1 != 0; e1 need not be a unit vector.
inline Metric metric_from_sizes(double h1, double h2, Vector e1) {
  const Vector e = (1 / norm(e1)) * e1;
  const double lambda1 = 1 / (h1 * h1), lambda2 = 1 / (h2 * h2);
  return {lambda1 * e.x * e.x + lambda2 * e.y * e.y, (lambda1 - lambda2) * e.x * e.y,
          lambda1 * e.y * e.y + lambda2 * e.x * e.x};
}

/// The isotropic metric of size h > 0.
inline Metric metric_from_size(double h) { return {1 / (h * h), 0, 1 / (h * h)}; }

/// h2 / h1 >= 1.
inline double stretch_of(const Metric& m) {
  const PrincipalAxes axes = principal_axes(m);
  return axes.h2 / axes.h1;
}

/// M^(1/2), in 1/length, stored like a metric (Eqn 14a). Maps to the normalised space: the length
/// of v is the Euclidean norm of M^(1/2) v (Eqns 10a, 10b).
inline Metric square_root(const Metric& m) {
  const double d = std::sqrt(determinant(m));
  const double s = 1 / std::sqrt(m.m11 + m.m22 + 2 * d);
  return {(m.m11 + d) * s, m.m12 * s, (m.m22 + d) * s};
}

/// du' M dv.
inline double inner_product(const Metric& m, Vector du, Vector dv) { return dot(du, m * dv); }

/// Anticlockwise angle from du to dv in the metric, radians in [0, 2 pi); 0 when they are parallel
/// or one of them vanishes (Eqn 9 with ERRATA). From the tangent, so exact near 0 and pi too.
inline double angle(const Metric& m, Vector du, Vector dv) {
  constexpr double kTwoPi = 6.283185307179586;
  const double sine = std::sqrt(determinant(m)) * cross(du, dv);
  const double phi = std::atan2(sine, inner_product(m, du, dv));
  const double positive = phi < 0 ? phi + kTwoPi : phi;
  return positive < kTwoPi ? positive : 0;
}

/// du turned anticlockwise in the metric by the angle of given cosine and sine; keeps its length.
/// Eqns 11-13 in closed form: dv = cos du + sin J du, J = [[-m12, -m22], [m11, m12]] / sqrt(det M).
inline Vector rotate(const Metric& m, Vector du, double cosine, double sine) {
  const double s = sine / std::sqrt(determinant(m));
  return {cosine * du.x - s * (m.m12 * du.x + m.m22 * du.y),
          cosine * du.y + s * (m.m11 * du.x + m.m12 * du.y)};
}
inline Vector rotate(const Metric& m, Vector du, double angle) {
  return rotate(m, du, std::cos(angle), std::sin(angle));
}

}  // namespace anisofront
