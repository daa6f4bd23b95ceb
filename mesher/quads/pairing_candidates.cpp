#include "mesher/quads/pairing_candidates.hpp"

#include "mesher/enhance/patch.hpp"
#include "mesher/metric/quality.hpp"
#include "mesher/quads/convexity.hpp"

namespace anisofront {
namespace {

/// beta~, or -1 when the quadrilateral is not strictly convex.
double convex_beta(const WorkMesh& mesh, const std::array<Index, 4>& quad) {
  std::array<Point, 4> p;
  std::array<MetricFactor, 4> r;
  for (std::size_t i = 0; i < 4; ++i) {
    p[i] = mesh.vertices[quad[i]].p;
    r[i] = mesh.vertices[quad[i]].r;
  }
  return is_convex_quad(p) ? beta(r, p) : -1;
}

}  // namespace

std::array<Index, 4> merged_quad(const WorkMesh& mesh, Index t, int k) {
  const WorkTriangle& triangle = mesh.triangles[t];
  const WorkTriangle& other = mesh.triangles[triangle.neighbours[k]];
  return {triangle.vertices[k], triangle.vertices[kNext[k]], other.vertices[side_towards(other, t)],
          triangle.vertices[kPrevious[k]]};
}

std::vector<MergeCandidate> merge_candidates(const WorkMesh& mesh) {
  std::vector<MergeCandidate> candidates;
  candidates.reserve(mesh.triangles.size() + mesh.triangles.size() / 2);
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    if (mesh.triangles[t].dead()) continue;
    for (int k = 0; k < 3; ++k) {
      const Index other = mesh.triangles[t].neighbours[k];
      if (other <= t) continue;  // a segment, or seen from the other side
      const double quality = convex_beta(mesh, merged_quad(mesh, t, k));
      if (quality > 0) candidates.push_back({t, other, quality});
    }
  }
  return candidates;
}

}  // namespace anisofront
