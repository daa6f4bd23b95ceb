#include "mesher/quads/pentagons.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {
namespace {

/// The corners at the nodes of the triangle.
constexpr std::array<std::size_t, 3> kOfTriangle{0, 1, 4};

/// Angle of the pentagon at vertex k (Eqn 9 in the metric there).
double corner_angle(const std::array<WorkVertex, 5>& p, std::size_t k) {
  const WorkVertex& at = p[k];
  return angle(metric_of(at.r), p[(k + 1) % 5].p - at.p, p[(k + 4) % 5].p - at.p);
}

}  // namespace

Cell join(const Cell& triangle, int i, const Cell& quad, int j) {
  const int k = (j + 1) % 4, l = (j + 2) % 4, m = (j + 3) % 4;
  const std::array<Index, 5>&v = quad.vertices, &e = quad.edges;
  return {5,
          {triangle.vertices[kPrevious[i]], v[k], v[l], v[m], v[j]},
          {triangle.edges[kPrevious[i]], e[k], e[l], e[m], triangle.edges[kNext[i]]}};
}

double angle_deviation(const std::array<WorkVertex, 5>& pentagon) {
  constexpr double kRightAngle = 1.5707963267948966;
  double deviation = 0;
  for (const std::size_t k : kOfTriangle)
    deviation += std::fabs(corner_angle(pentagon, k) - kRightAngle);  // Eqn 28
  return deviation;
}

bool has_flat_corner(const std::array<WorkVertex, 5>& pentagon) {
  constexpr double kFlat = 2.8797932657906435;  // 165 degrees
  return std::any_of(kOfTriangle.begin(), kOfTriangle.end(),
                     [&](std::size_t k) { return corner_angle(pentagon, k) > kFlat; });
}

}  // namespace anisofront
