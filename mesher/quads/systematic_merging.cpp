#include "mesher/quads/systematic_merging.hpp"

#include <array>
#include <queue>
#include <tuple>

#include "mesher/enhance/patch.hpp"

namespace anisofront {
namespace {

/// A triangle at the front as it was when it was queued.
struct Turn {
  bool forced;  ///< one neighbour left to merge with: before all others
  Index level;  ///< layers merged between it and the segments
  double beta;  ///< of its best quadrilateral
  Index triangle;
  friend bool operator>(const Turn& a, const Turn& b) {
    return std::tie(b.forced, a.level, b.beta, a.triangle) >
           std::tie(a.forced, b.level, a.beta, b.triangle);
  }
  friend bool operator==(const Turn&, const Turn&) = default;
};

/// The neighbours with which a triangle can still be merged.
struct Choices {
  Index best = kNoIndex;  ///< kNoIndex: none
  double best_beta = 0;
  int count = 0;
};

struct Merging {
  const WorkMesh& mesh;
  std::vector<std::array<double, 3>> beta;  ///< per side of a triangle; 0: not to be merged
  std::vector<Index> level;                 ///< per triangle; kNoIndex: not at the front
  std::vector<Index> mates;
  std::priority_queue<Turn, std::vector<Turn>, std::greater<>> queue;
};

Choices choices_of(const Merging& merging, Index t) {
  Choices choices;
  for (int k = 0; k < 3; ++k) {
    const Index neighbour = merging.mesh.triangles[t].neighbours[k];
    const double beta = merging.beta[t][k];
    if (beta <= 0 || merging.mates[neighbour] != kNoIndex) continue;
    ++choices.count;
    if (beta > choices.best_beta) {
      choices.best = neighbour;
      choices.best_beta = beta;
    }
  }
  return choices;
}

Turn turn_of(const Merging& merging, Index t, const Choices& choices) {
  return {choices.count == 1, merging.level[t], choices.best_beta, t};
}

/// Triangles with nobody to merge with stay alone.
void enqueue(Merging& merging, Index t) {
  const Choices choices = choices_of(merging, t);
  if (choices.count > 0) merging.queue.push(turn_of(merging, t, choices));
}

void advance_to(Merging& merging, Index t, Index level) {
  if (t < 0 || merging.mates[t] != kNoIndex) return;
  if (merging.level[t] == kNoIndex || merging.level[t] > level) merging.level[t] = level;
  enqueue(merging, t);
}

void merge(Merging& merging, Index t, Index other) {
  merging.mates[t] = other;
  merging.mates[other] = t;
  const Index level = merging.level[t] + 1;
  for (const Index u : {t, other})
    for (const Index n : merging.mesh.triangles[u].neighbours) advance_to(merging, n, level);
}

Merging start(const WorkMesh& mesh, const std::vector<MergeCandidate>& candidates) {
  const std::size_t triangles = mesh.triangles.size();
  Merging merging{mesh,
                  std::vector<std::array<double, 3>>(triangles, {0, 0, 0}),
                  std::vector<Index>(triangles, kNoIndex),
                  std::vector<Index>(triangles, kNoIndex),
                  {}};
  for (const auto& [first, second, beta] : candidates) {
    if (beta < kLeastMergedBeta) continue;
    merging.beta[first][side_towards(mesh.triangles[first], second)] = beta;
    merging.beta[second][side_towards(mesh.triangles[second], first)] = beta;
  }
  for (Index t = 0; t < static_cast<Index>(triangles); ++t)
    for (const Index n : mesh.triangles[t].neighbours)
      if (n < 0 && merging.level[t] == kNoIndex) advance_to(merging, t, 0);
  return merging;
}

}  // namespace

std::vector<Index> systematic_merging(const WorkMesh& mesh,
                                      const std::vector<MergeCandidate>& candidates) {
  Merging merging = start(mesh, candidates);
  while (!merging.queue.empty()) {
    const Turn turn = merging.queue.top();
    merging.queue.pop();
    const Index t = turn.triangle;
    if (merging.mates[t] != kNoIndex) continue;
    const Choices choices = choices_of(merging, t);
    if (choices.count > 0 && turn_of(merging, t, choices) == turn)  // else queued anew since
      merge(merging, t, choices.best);
  }
  return merging.mates;
}

}  // namespace anisofront
