#include "mesher/enhance/vertex_energy.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/geometry/predicates.hpp"

namespace anisofront {

void VertexEnergy::load(const Patch& patch, const Ring& ring) {
  size_ = ring.size;
  for (int i = 0; i < size_; ++i) {
    const WorkVertex& v = patch.vertex(ring.vertices[i]);
    p_[i] = v.p;
    r_[i] = v.r;
  }
  p_[size_] = p_[0];
  r_[size_] = r_[0];
}

double VertexEnergy::operator()(const WorkVertex& x, double limit) {
  constexpr double kInvalid = 1e30, kLengthWeight = 4.33, kTwoSqrt3 = 3.4641016151377544;
  double energy = 0;
  Vector u = p_[0] - x.p;
  for (int i = 0; i < size_; ++i) {
    const Vector v = p_[i + 1] - x.p;
    // Squared length as the geometric mean of the two end metrics.
    const double l2 =
        std::sqrt(anisofront::squared_length(x.r, u) * anisofront::squared_length(r_[i], u));
    squared_length_[i] = l2;
    const MetricFactor m = sum(x.r, r_[i], r_[i + 1]);
    const Vector p{m.a * u.x + m.b * u.y, m.c * u.y};
    const Vector q{m.a * v.x + m.b * v.y, m.c * v.y};
    const double area = cross(p, q);
    if (area <= 0) return kInvalid;
    const double inverse_alpha =
        (squared_norm(p) + squared_norm(q) + squared_norm(q - p)) / (kTwoSqrt3 * area);
    const double stretch = l2 + 1 / l2 - 2;
    energy += inverse_alpha * inverse_alpha * inverse_alpha - 1 + kLengthWeight * stretch * stretch;
    if (energy > limit) return energy;
    u = v;
  }
  return energy;
}

Vector VertexEnergy::length_proposal(const WorkVertex& x) const {
  Vector sum{0, 0};
  for (int i = 0; i < size_; ++i)
    sum = sum + (1 - 1 / std::sqrt(squared_length_[i])) * (p_[i] - x.p);
  return (1. / size_) * sum;
}

Vector VertexEnergy::quality_proposal(const WorkVertex& x) const {
  constexpr double kHalfSqrt3 = 0.86602540378443865;
  Vector total{0, 0};
  for (int i = 0; i < size_; ++i) {
    const MetricFactor r{0.5 * (r_[i].a + r_[i + 1].a), 0.5 * (r_[i].b + r_[i + 1].b),
                         0.5 * (r_[i].c + r_[i + 1].c)};
    const Vector e = p_[i + 1] - p_[i];
    const double s = r.a * e.x + r.b * e.y, t = r.c * e.y;
    const double height = kHalfSqrt3 * std::clamp(1 / std::sqrt(s * s + t * t), 0.77, 1.3);
    const double y = s * height / r.c;
    total = total + 0.5 * (p_[i] + p_[i + 1]) + Vector{(-t * height - r.b * y) / r.a, y} - x.p;
  }
  return (1. / size_) * total;
}

bool VertexEnergy::is_valid(Point p) const {
  for (int i = 0; i < size_; ++i)
    if (orientation(p, p_[i], p_[i + 1]) <= 0) return false;
  return true;
}

}  // namespace anisofront
