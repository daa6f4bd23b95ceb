#include "mesher/quads/pairing.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/enhance/patch.hpp"
#include "mesher/quads/block_matching.hpp"
#include "mesher/quads/pairing_candidates.hpp"
#include "mesher/quads/systematic_merging.hpp"

namespace anisofront {
namespace {

/// The paper, section 3, step (i): edges are removed one by one, the best quadrilateral first.
std::vector<Index> best_first(std::size_t triangles, std::vector<MergeCandidate> candidates) {
  std::stable_sort(
      candidates.begin(), candidates.end(),
      [](const MergeCandidate& a, const MergeCandidate& b) { return a.beta > b.beta; });
  std::vector<Index> mates(triangles, kNoIndex);
  for (const auto& [first, second, beta] : candidates) {
    if (beta < kLeastMergedBeta) break;
    if (mates[first] != kNoIndex || mates[second] != kNoIndex) continue;
    mates[first] = second;
    mates[second] = first;
  }
  return mates;
}

/// A pair is worth 1000 and loses 100 ln(1 / beta~), at most 500: so nearly as many pairs as can
/// be, and the geometric mean of beta~ decides among them.
std::int64_t weight(double beta) {
  constexpr double kScale = 1000;
  return std::llround(kScale * (1000 + 100 * std::max(std::log(beta), -5.)));
}

std::vector<Index> best_matching(const WorkMesh& mesh,
                                 const std::vector<MergeCandidate>& candidates) {
  std::vector<WeightedPair> pairs;
  pairs.reserve(candidates.size());
  for (const MergeCandidate& c : candidates) pairs.push_back({c.first, c.second, weight(c.beta)});
  return match_in_blocks(mesh, pairs);
}

/// Per triangle that with which it becomes a quadrilateral, or kNoIndex.
std::vector<Index> mates_of(const WorkMesh& mesh, Pairing pairing) {
  switch (pairing) {
    case Pairing::beta_order:
      return best_first(mesh.triangles.size(), merge_candidates(mesh));
    case Pairing::matching:
      return best_matching(mesh, merge_candidates(mesh));
    case Pairing::systematic:
      break;
  }
  return systematic_merging(mesh, merge_candidates(mesh));
}

std::vector<MixedFace> merged_faces(const WorkMesh& mesh, const std::vector<Index>& mates) {
  std::vector<MixedFace> faces;
  faces.reserve(mates.size());
  for (Index t = 0; t < static_cast<Index>(mates.size()); ++t) {
    const WorkTriangle& triangle = mesh.triangles[t];
    if (triangle.dead()) continue;
    const auto [a, b, c] = triangle.vertices;
    if (mates[t] == kNoIndex)
      faces.push_back({{a, b, c, kNoIndex}});
    else if (t < mates[t])
      faces.push_back({merged_quad(mesh, t, side_towards(triangle, mates[t]))});
  }
  return faces;
}

}  // namespace

MixedMesh pair_triangles(const WorkMesh& mesh, const std::vector<Index>& required,
                         Pairing pairing) {
  MixedMesh mixed{mesh.vertices, mesh.segments, merged_faces(mesh, mates_of(mesh, pairing)), {}};
  mixed.required.assign(mesh.vertices.size(), 0);
  for (const Index v : required) mixed.required[v] = 1;
  return mixed;
}

}  // namespace anisofront
