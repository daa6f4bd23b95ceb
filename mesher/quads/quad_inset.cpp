#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "mesher/geometry/convex_polygon.hpp"
#include "mesher/quads/quad_operations.hpp"

namespace anisofront {
namespace {

/// A point from which all of the quadrilateral is seen: the mean of the corners of its kernel,
/// which is empty unless the quadrilateral is simple.
std::optional<Point> kernel_point(const std::array<Point, 4>& p) {
  Point low = p[0], high = p[0];
  for (const Point x : p) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y)};
  }
  std::vector<Point> kernel{low, {high.x, low.y}, high, {low.x, high.y}};
  for (int k = 0; k < 4; ++k) kernel = left_part(kernel, p[k], p[(k + 1) & 3]);
  if (kernel.size() < 3) return {};
  Point sum{0, 0};
  for (const Point x : kernel) sum = sum + x;
  return (1. / static_cast<double>(kernel.size())) * sum;
}

/// Corners at equal metric distance from the centre on the rays to those of the quadrilateral: then
/// all five quadrilaterals are convex, whatever the one they replace. Empty when that has no
/// kernel.
std::optional<std::array<WorkVertex, 4>> inset_corners(const QuadWork& work,
                                                       const std::array<Index, 4>& corners) {
  constexpr double kShare = 0.5;
  std::array<Point, 4> p;
  for (int k = 0; k < 4; ++k) p[k] = work.mesh.vertices[corners[k]].p;
  const std::optional<Point> centre = kernel_point(p);
  if (!centre) return {};
  Index hint = work.mesh.vertices[corners[0]].hint;
  const MetricFactor r = work.background.factor_at(*centre, hint);
  double least = 1e300;
  for (const Point x : p) least = std::min(least, squared_length(r, x - *centre));
  if (!(least > 0)) return {};
  std::array<WorkVertex, 4> result;
  for (int k = 0; k < 4; ++k) {
    const Vector u = p[k] - *centre;
    result[k] = {*centre + kShare * std::sqrt(least / squared_length(r, u)) * u, {}, hint};
    result[k].r = work.background.factor_at(result[k].p, result[k].hint);
  }
  return result;
}

}  // namespace

bool inset_quad(QuadWork& work, Index quad) {
  constexpr int kMostAround = 30;
  const QuadMesh& mesh = work.mesh;
  const Index inner = 4 * quad;
  std::array<Index, 4> corners, twins, inset, ring;
  for (int k = 0; k < 4; ++k) {
    corners[k] = mesh.corner[inner + k];
    twins[k] = mesh.twin[inner + k];
    if (mesh.valence[corners[k]] >= kMostAround) return false;
  }
  const auto places = inset_corners(work, corners);
  if (!places) return false;
  work.begin();
  work.touch_quad(quad);
  for (int k = 0; k < 4; ++k) {
    inset[k] = work.add_vertex((*places)[k]);
    ring[k] = 4 * work.add_quad();
  }
  for (int k = 0; k < 4; ++k) {
    const int j = (k + 1) & 3;
    work.set_corner(inner + k, inset[k]);
    const std::array<Index, 4> side{corners[k], corners[j], inset[j], inset[k]};
    for (int i = 0; i < 4; ++i) work.set_corner(ring[k] + i, side[i]);
    work.sew(ring[k], twins[k]);
    work.sew(ring[k] + 1, ring[j] + 3);
    work.sew(ring[k] + 2, inner + k);
  }
  for (int k = 0; k < 4; ++k) {
    work.recount(ring[k]);
    work.recount(inner + k);
  }
  return true;
}

}  // namespace anisofront
