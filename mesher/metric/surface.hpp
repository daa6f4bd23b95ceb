#pragma once

#include <array>

#include "mesher/metric/metric.hpp"

namespace anisofront {

/// A point or a vector of space.
struct Vector3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vector3&, const Vector3&) = default;
};
inline double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Symmetric 3x3 tensor [[a, b, d], [b, c, e], [d, e, f]], letters as in (A1), in 1/length^2 where
/// it is a metric.
struct Metric3 {
  double a = 1, b = 0, c = 1, d = 0, e = 0, f = 1;
  friend bool operator==(const Metric3&, const Metric3&) = default;
};

inline Vector3 operator*(const Metric3& m, const Vector3& v) {
  return {m.a * v.x + m.b * v.y + m.d * v.z, m.b * v.x + m.c * v.y + m.e * v.z,
          m.d * v.x + m.e * v.y + m.f * v.z};
}

/// Squared length of v (A2).
inline double squared_length(const Metric3& m, const Vector3& v) { return dot(v, m * v); }

/// Eigenvalues in descending order and unit eigenvectors of a symmetric tensor (A1): m = sum of
/// values[i] vectors[i] vectors[i]'. The sizes are h_i = values[i]^(-1/2), so h1 <= h2 <= h3.
struct Eigenpairs3 {
  std::array<double, 3> values{};
  std::array<Vector3, 3> vectors{};
};
/// Cyclic Jacobi rotations; residual about 1e-15 of the largest entry. Any finite symmetric tensor.
Eigenpairs3 eigenpairs(const Metric3& m);

/// True when all entries are finite and all eigenvalues positive. (A positive determinant, as
/// printed with A1, is not enough: diag(-1, -1, 1).)
bool is_positive_definite(const Metric3& m);

/// M^(1/2) and M^(-1/2) (A3a, A3b). Precondition: m is positive definite.
Metric3 square_root(const Metric3& m);
Metric3 inverse_square_root(const Metric3& m);

/// M_uv: lengths on the surface r(u, v) measured in parameters, from the derivatives r,u and r,v
/// (A6, A7 with ERRATA: the first entry is r,u . r,u). Singular where they are parallel.
Metric surface_metric(const Vector3& r_u, const Vector3& r_v);

/// M_sur: the same with lengths in space measured by m (A8, A9).
Metric surface_metric(const Metric3& m, const Vector3& r_u, const Vector3& r_v);

}  // namespace anisofront
