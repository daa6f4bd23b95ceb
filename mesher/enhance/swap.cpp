#include "mesher/enhance/swap.hpp"

#include <algorithm>

#include "mesher/geometry/predicates.hpp"

namespace anisofront {
namespace {

/// Turns the diagonal bc of the quadrilateral a b d c (triangles t = abc, u = dcb) into ad.
void flip(Patch& patch, Index t, int k, Index u, int j) {
  WorkTriangle &left = patch.mesh.triangles[t], &right = patch.mesh.triangles[u];
  const Index a = left.vertices[k], b = left.vertices[kNext[k]], c = left.vertices[kPrevious[k]];
  const Index d = right.vertices[j];
  const Index across_ca = left.neighbours[kNext[k]], across_ab = left.neighbours[kPrevious[k]];
  const Index across_bd = right.neighbours[kNext[j]], across_dc = right.neighbours[kPrevious[j]];
  left = {{a, b, d}, {across_bd, u, across_ab}};
  right = {{a, d, c}, {across_dc, across_ca, t}};
  replace_neighbour(patch.mesh, across_bd, u, t);
  replace_neighbour(patch.mesh, across_ca, t, u);
  patch.triangle_of[a] = patch.triangle_of[b] = t;
  patch.triangle_of[c] = patch.triangle_of[d] = u;
  patch.update_alpha(t);
  patch.update_alpha(u);
  patch.activate(t);
  patch.activate(u);
  ++patch.statistics.swaps;
}

}  // namespace

bool try_swap(Patch& patch, Index t, int k, SwapCriterion criterion) {
  constexpr double kLeastGain = 1e-6;
  const WorkTriangle& left = patch.mesh.triangles[t];
  const Index u = left.neighbours[k];
  if (u < 0) return false;
  const WorkTriangle& right = patch.mesh.triangles[u];
  const int j = side_towards(right, t);
  const Index a = left.vertices[k], b = left.vertices[kNext[k]], c = left.vertices[kPrevious[k]];
  const Index d = right.vertices[j];
  const double old1 = patch.alpha[t], old2 = patch.alpha[u];
  const bool product = criterion == SwapCriterion::product;
  const double old_value = product ? old1 * old2 : std::min(old1, old2);
  const double new1 = patch.alpha_of(a, b, d);
  if (new1 <= 0 || new1 <= old_value) return false;  // the other factor is at most 1
  const double new2 = patch.alpha_of(a, d, c);
  if (new2 <= 0) return false;
  const double new_value = product ? new1 * new2 : std::min(new1, new2);
  if (new_value <= old_value + kLeastGain) return false;
  return force_swap(patch, t, k);
}

bool force_swap(Patch& patch, Index t, int k) {
  const WorkTriangle& left = patch.mesh.triangles[t];
  const Index u = left.neighbours[k];
  if (u < 0) return false;
  const int j = side_towards(patch.mesh.triangles[u], t);
  const Point a = patch.point(left.vertices[k]), b = patch.point(left.vertices[kNext[k]]),
              c = patch.point(left.vertices[kPrevious[k]]),
              d = patch.point(patch.mesh.triangles[u].vertices[j]);
  if (orientation(a, b, d) <= 0 || orientation(a, d, c) <= 0) return false;
  flip(patch, t, k, u, j);
  return true;
}

void swap_all(Patch& patch, SwapCriterion criterion, double threshold) {
  const auto limit = static_cast<float>(threshold);
  std::vector<Index> queue;
  const auto visit = [&](Index t) {
    for (int k = 0; k < 3; ++k) {
      const Index u = patch.mesh.triangles[t].neighbours[k];
      if (u < 0 || std::min(patch.alpha[t], patch.alpha[u]) > limit) continue;
      if (!try_swap(patch, t, k, criterion)) continue;
      queue.push_back(t);
      queue.push_back(u);
      return;
    }
  };
  for (Index t = 0; t < static_cast<Index>(patch.mesh.triangles.size()); ++t) {
    if (patch.mesh.triangles[t].dead() || patch.alpha[t] > limit) continue;
    visit(t);
    while (!queue.empty()) {
      const Index next = queue.back();
      queue.pop_back();
      visit(next);
    }
  }
}

}  // namespace anisofront
