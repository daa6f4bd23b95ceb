#include "mesher/quads/block_matching.hpp"

#include <algorithm>
#include <span>

namespace anisofront {
namespace {

struct BlockMatching {
  const std::vector<WeightedPair>& pairs;
  std::size_t largest_block;
  std::vector<Point> centres;      ///< per triangle
  std::vector<std::size_t> begin;  ///< pairs with `first` t: begin[t] .. begin[t + 1] - 1
  std::vector<Index> mates;        ///< so far
  std::vector<Index> local;        ///< per triangle: number in the block at work, or kNoIndex
};

std::vector<Point> centres_of(const WorkMesh& mesh) {
  std::vector<Point> centres(mesh.triangles.size());
  for (std::size_t t = 0; t < centres.size(); ++t) {
    if (mesh.triangles[t].dead()) continue;
    const auto& [a, b, c] = mesh.triangles[t].vertices;
    centres[t] = (1. / 3) * (mesh.vertices[a].p + mesh.vertices[b].p + mesh.vertices[c].p);
  }
  return centres;
}

std::vector<std::size_t> begins_of(const std::vector<WeightedPair>& pairs, std::size_t triangles) {
  std::vector<std::size_t> begin(triangles + 1, 0);
  for (const WeightedPair& pair : pairs) ++begin[static_cast<std::size_t>(pair.first) + 1];
  for (std::size_t t = 0; t < triangles; ++t) begin[t + 1] += begin[t];
  return begin;
}

/// The triangles of the block that are alone or have their mate in it, numbered.
std::vector<Index> free_triangles(BlockMatching& m, std::span<const Index> block) {
  for (const Index t : block) m.local[t] = 0;
  std::vector<Index> free;
  for (const Index t : block)
    if (m.mates[t] == kNoIndex || m.local[m.mates[t]] != kNoIndex) free.push_back(t);
  for (const Index t : block) m.local[t] = kNoIndex;
  for (std::size_t i = 0; i < free.size(); ++i) m.local[free[i]] = static_cast<Index>(i);
  return free;
}

void match_block(BlockMatching& m, std::span<Index> block) {
  std::sort(block.begin(), block.end());
  const std::vector<Index> free = free_triangles(m, block);
  std::vector<WeightedPair> inside;
  for (const Index t : free)
    for (std::size_t i = m.begin[t]; i < m.begin[static_cast<std::size_t>(t) + 1]; ++i)
      if (m.local[m.pairs[i].second] != kNoIndex)
        inside.push_back({m.local[t], m.local[m.pairs[i].second], m.pairs[i].weight});
  const std::vector<Index> found = maximum_weight_matching(static_cast<Index>(free.size()), inside);
  for (std::size_t i = 0; i < free.size(); ++i)
    m.mates[free[i]] = found[i] == kNoIndex ? kNoIndex : free[found[i]];
  for (const Index t : free) m.local[t] = kNoIndex;
}

bool wider_than_high(const BlockMatching& m, std::span<const Index> triangles) {
  Point low = m.centres[triangles[0]], high = low;
  for (const Index t : triangles) {
    const Point p = m.centres[t];
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return high.x - low.x > high.y - low.y;
}

/// Cuts the triangles across their longer side, `share` of them on the lower side, until the parts
/// are small enough.
void match_parts(BlockMatching& m, std::span<Index> triangles, double share) {
  if (triangles.size() <= m.largest_block) return match_block(m, triangles);
  const double Point::*axis = wider_than_high(m, triangles) ? &Point::x : &Point::y;
  const auto lower = static_cast<std::size_t>(share * static_cast<double>(triangles.size()));
  std::nth_element(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(lower),
                   triangles.end(), [&](Index a, Index b) {
                     const double x = m.centres[a].*axis, y = m.centres[b].*axis;
                     return x < y || (x == y && a < b);
                   });
  match_parts(m, triangles.first(lower), share);
  match_parts(m, triangles.subspan(lower), share);
}

}  // namespace

std::vector<Index> match_in_blocks(const WorkMesh& mesh, const std::vector<WeightedPair>& pairs,
                                   std::size_t largest_block) {
  const std::size_t count = mesh.triangles.size();
  BlockMatching m{pairs,
                  std::max<std::size_t>(largest_block, 2),
                  centres_of(mesh),
                  begins_of(pairs, count),
                  std::vector<Index>(count, kNoIndex),
                  std::vector<Index>(count, kNoIndex)};
  std::vector<Index> triangles;
  for (std::size_t t = 0; t < count; ++t)
    if (!mesh.triangles[t].dead()) triangles.push_back(static_cast<Index>(t));
  match_parts(m, triangles, 1. / 2);
  if (triangles.size() > m.largest_block) match_parts(m, triangles, 1. / 3);
  return m.mates;
}

}  // namespace anisofront
