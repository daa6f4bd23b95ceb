#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "mesher/front/work_mesh.hpp"

namespace anisofront {

/// Defect energy of a quadrilateral mesh, a sum over the quadrilaterals:
///   E = sum [ S + shape2 S^2 + (length / 4) sum over its edges of (z^2 + z^4) - potential ],
/// with length / 2 for edges on the boundary, which have one quadrilateral only.
/// S = (1 / beta~ - beta~) / 2 (Eqn 16), which is sinh(-ln beta~): the sum of -ln beta~ is the
/// geometric mean of beta~, and the bad weigh more. z = log2(l^2), 1 at an edge of length sqrt 2.
/// `potential` is the defect of a mean quadrilateral, without which removing any of them would pay.
struct QuadWeights {
  double shape2 = 0;
  double length = 0.35;
  double potential = 0.3;
  bool middle_lengths = false;  ///< l by Simpson's rule: sees a layer that is crossed mid-edge
};

/// Shape energy of a quadrilateral with the four alpha~ sorted, low the product of the smaller two
/// and high of the others, so that beta~ = low / high; `least` is the least of them: where it is
/// not positive the energy is between `not_convex` and 17/16 of it.
inline double shape_energy(double low, double high, double least, const QuadWeights& weights,
                           double not_convex) {
  constexpr double kMost = 36;
  if (least <= 0) return not_convex * (1 + 0.0625 * std::min(1., -least));
  const double shape = 0.5 * (high * high - low * low) / (low * high);
  return std::min(shape + weights.shape2 * shape * shape, kMost);
}

/// z^2 + z^4 of an edge from its squared lengths in the metrics of its ends, in terms of
/// t = 2 cosh(2 z ln 2) - 2, which needs no logarithm: within 10 % for |z| in [0.25, 1.1]. Less
/// steep for lengths below 0.66, as a repair may need short edges, and above 2.5.
inline double length_defect(double squared1, double squared2) {
  constexpr double kShort = 3, kSqrt3 = 1.7320508075688772, kLong = 40;
  const double y = squared1 * squared2;
  const double t = std::min(y + 1 / y - 2, 1e9);  // finite for edges of no length
  if (t <= kShort || y > 1) return t * (0.52 + 0.17 * std::min(t, kLong));
  return kShort * (0.52 + 0.17 * kShort) +
         (0.52 + 0.34 * kShort) * 2 * kSqrt3 * (std::sqrt(t) - kSqrt3);
}

/// The four alpha~ of a quadrilateral: product of the smaller two, of the larger two, and the least
/// of them. Of a negative one only the sign is that of alpha~.
struct QuadShape {
  double low, high, least;
  /// beta~ (Eqn 16b); means something only where `least` is positive.
  double beta() const { return low / high; }
};

/// Two metrics side by side: every operation on a Pair is one instruction on both.
using Pair = double __attribute__((vector_size(16)));

struct MetricPair {
  Pair a, b, c;
  Pair inverse;  ///< 1 / (2 sqrt3 sqrt(det M))
};

inline double inverse_of(const MetricFactor& r) {
  constexpr double kInverseTwoSqrt3 = 0.28867513459481287;
  return kInverseTwoSqrt3 / (r.a * r.c);
}

inline MetricPair metric_pair(const MetricFactor& first, double first_inverse,
                              const MetricFactor& second, double second_inverse) {
  return {Pair{first.a, second.a}, Pair{first.b, second.b}, Pair{first.c, second.c},
          Pair{first_inverse, second_inverse}};
}

/// A vector in the coordinates in which each of two metrics is the unit metric (Eqn 10b).
struct ScaledPair {
  Pair x, y;
};
inline ScaledPair scaled(const MetricPair& m, Vector v) {
  return {m.a * v.x + m.b * v.y, m.c * v.y};
}
inline Pair squared_length(const ScaledPair& v) { return v.x * v.x + v.y * v.y; }
inline Pair squared_distance(const ScaledPair& u, const ScaledPair& v) {
  const ScaledPair w{v.x - u.x, v.y - u.y};
  return squared_length(w);
}

/// The quadrilateral p q t g seen from p, which is being moved: what does not depend on p is
/// computed once. Its triangles are pqt, ptg, pqg and qtg (Eqn 16b); alpha~ of each is its area
/// over the largest, in the metrics of its vertices, of (sum of squared sides) / (2 sqrt3
/// sqrt(det M)) (Eqn 15).
struct QuadView {
  Point q, t, g;
  MetricFactor at_q;
  double inverse_q;
  MetricPair at_tg;
  Pair tq, tg, qg;  ///< squared sides qt, tg, qg over 2 sqrt3 sqrt(det M), in the metrics of t, g
  double alpha_qtg;
};

inline QuadView quad_view(const WorkVertex& q, const WorkVertex& t, const WorkVertex& g) {
  QuadView view;
  view.q = q.p;
  view.t = t.p;
  view.g = g.p;
  view.at_q = q.r;
  view.inverse_q = inverse_of(q.r);
  view.at_tg = metric_pair(t.r, inverse_of(t.r), g.r, inverse_of(g.r));
  const ScaledPair qt = scaled(view.at_tg, t.p - q.p), qg = scaled(view.at_tg, g.p - q.p);
  view.tq = squared_length(qt) * view.at_tg.inverse;
  view.qg = squared_length(qg) * view.at_tg.inverse;
  view.tg = squared_distance(qt, qg) * view.at_tg.inverse;
  const Pair sum = view.tq + view.tg + view.qg;
  const double at_q = (squared_length(q.r, t.p - q.p) + squared_length(q.r, g.p - q.p) +
                       squared_length(q.r, g.p - t.p)) *
                      view.inverse_q;
  const double largest = std::max(at_q, std::max(sum[0], sum[1]));
  view.alpha_qtg = cross(t.p - q.p, g.p - q.p) / largest;
  return view;
}

/// Shape of p q t g; `at_p` is the metric of p, `inverse_p` = inverse_of(at_p).
inline QuadShape quad_shape(const QuadView& view, Point p, const MetricFactor& at_p,
                            double inverse_p) {
  const Vector u = view.q - p, v = view.t - p, w = view.g - p;
  const MetricPair pq = metric_pair(at_p, inverse_p, view.at_q, view.inverse_q);
  const ScaledPair u0 = scaled(pq, u), v0 = scaled(pq, v), w0 = scaled(pq, w);
  const Pair q0 = squared_length(u0), t0 = squared_length(v0), g0 = squared_length(w0);
  const Pair pqt0 = (q0 + t0 + squared_distance(u0, v0)) * pq.inverse;
  const Pair ptg0 = (t0 + g0 + squared_distance(v0, w0)) * pq.inverse;
  const Pair pqg0 = (q0 + g0 + squared_distance(u0, w0)) * pq.inverse;
  const Pair q1 = squared_length(scaled(view.at_tg, u)) * view.at_tg.inverse;
  const Pair t1 = squared_length(scaled(view.at_tg, v)) * view.at_tg.inverse;
  const Pair g1 = squared_length(scaled(view.at_tg, w)) * view.at_tg.inverse;
  const Pair pqt1 = q1 + t1 + view.tq, ptg1 = t1 + g1 + view.tg, pqg1 = q1 + g1 + view.qg;
  const auto largest = [](double x, double y, double z) { return std::max(x, std::max(y, z)); };
  const Pair first = Pair{cross(u, v), cross(v, w)} /
                     Pair{largest(pqt0[0], pqt0[1], pqt1[0]), largest(ptg0[0], ptg1[0], ptg1[1])};
  const double pqg = cross(u, w) / largest(pqg0[0], pqg0[1], pqg1[1]);
  const double x0 = std::min(first[0], first[1]), x1 = std::max(first[0], first[1]);
  const double y0 = std::min(pqg, view.alpha_qtg), y1 = std::max(pqg, view.alpha_qtg);
  const double least = std::min(x0, y0), greatest = std::max(x1, y1);
  const double middle1 = std::max(x0, y0), middle2 = std::min(x1, y1);
  const double low = std::min(middle1, middle2), high = std::max(middle1, middle2);
  return {least * low, greatest * high, least};
}

}  // namespace anisofront
