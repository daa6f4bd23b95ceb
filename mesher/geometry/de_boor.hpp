#pragma once

#include <array>
#include <vector>

#include "mesher/geometry/curve.hpp"

namespace anisofront::detail {

/// A control point (w x, w y, w).
struct Homogeneous {
  double x, y, w;
};

/// De Boor's triangle of one knot span (The NURBS Book, Eqn 5.15), column by column in place.
class DeBoor {
 public:
  DeBoor(const NurbsCurve& curve, std::size_t span)
      : knots_(curve.knots.data() + span), degree_(static_cast<std::size_t>(curve.degree)) {
    if (degree_ >= inline_.size()) large_.resize(degree_ + 1);
    column_ = large_.empty() ? inline_.data() : large_.data();
    for (std::size_t j = 0; j <= degree_; ++j) {
      const std::size_t i = span - degree_ + j;
      const double w = curve.weights[i];
      column_[j] = {w * curve.points[i].x, w * curve.points[i].y, w};
    }
  }
  DeBoor(const DeBoor&) = delete;
  DeBoor& operator=(const DeBoor&) = delete;

  /// Column `level` (1..degree) from the one before. Different t on different levels give the
  /// blossom of the curve; the result after the last level is [degree].
  void step(std::size_t level, double t) {
    for (std::size_t j = degree_; j >= level; --j) {
      const double left =
          knots_[static_cast<std::ptrdiff_t>(j) - static_cast<std::ptrdiff_t>(degree_)];
      const double right = knots_[j + 1 - level];
      const double a = (t - left) / (right - left);
      const Homogeneous &p = column_[j - 1], &q = column_[j];
      column_[j] = {(1 - a) * p.x + a * q.x, (1 - a) * p.y + a * q.y, (1 - a) * p.w + a * q.w};
    }
  }

  const Homogeneous& operator[](std::size_t j) const { return column_[j]; }

 private:
  const double* knots_;
  std::size_t degree_;
  std::array<Homogeneous, 6> inline_;  ///< degrees that occur in practice need no allocation
  std::vector<Homogeneous> large_;
  Homogeneous* column_;
};

}  // namespace anisofront::detail
