#pragma once

#include <array>
#include <span>

#include "mesher/metric/metric_field.hpp"

namespace anisofront {

/// Common basis of two metrics (Eqn 4, with ERRATA: M1 S = M2 S Lambda): the columns of S
/// diagonalise both, lambda_i = s_i' M1 s_i and mu_i = s_i' M2 s_i. Scaled so that mu_i = 1.
struct SimultaneousReduction {
  Vector s1, s2;
  double lambda1 = 1, lambda2 = 1;
  double mu1 = 1, mu2 = 1;
};
/// Stable for equal metrics and equal eigenvalues (Cholesky + symmetric 2x2 eigenproblem).
SimultaneousReduction simultaneous_reduction(const Metric& m1, const Metric& m2);

/// The metric with squared lengths q1, q2 along s1, s2: S^-T diag(q1, q2) S^-1 (Eqns 7 and 8).
Metric metric_from_reduction(Vector s1, Vector s2, double q1, double q2);

/// Metric at P1 + t (P2 - P1), 0 <= t <= 1 (Eqns 4-7 for simultaneous_reduction).
/// Laws: t=0 gives m1, t=1 gives m2, the result is positive definite; swapping the metrics and t
/// with 1-t changes nothing.
Metric interpolate(Interpolation method, const Metric& m1, const Metric& m2, double t);

/// Metric at barycentric coordinates in a triangle (non-negative, sum 1). simultaneous_reduction:
/// along an edge, then to the remaining vertex (Fig. 2a); the remaining vertex is the one of
/// largest det M, ties by vertex order.
Metric interpolate(Interpolation method, const std::array<Metric, 3>& m,
                   const std::array<double, 3>& barycentric);

/// Metric at local coordinates (xi, eta) in [0,1]^2 of a quadrilateral with vertices
/// (0,0) (1,0) (1,1) (0,1): along two opposite edges, then across (Fig. 2b).
Metric interpolate(Interpolation method, const std::array<Metric, 4>& m, double xi, double eta);

/// Local coordinates of p in a convex quadrilateral (inverse of the bilinear map), clamped to
/// [0,1]^2.
std::array<double, 2> bilinear_coordinates(const std::array<Point, 4>& quad, Point p);

/// Matrix logarithm and exponential of symmetric tensors stored like Metric.
Metric logarithm(const Metric& m);
Metric exponential(const Metric& log_m);

}  // namespace anisofront
