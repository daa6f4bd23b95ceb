#include "mesher/quads/quad_clean.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "mesher/quads/quad_operations.hpp"
#include "mesher/quads/quad_smooth.hpp"

namespace anisofront {
namespace {

/// One cycle of smoothing inside a trial and the energy above which the trial is given up after it;
/// `desperate` for quadrilaterals so bad that more is worth trying.
struct TrialCycle {
  double first_step, last_step, reject, reject_desperate;
  bool repeat;
};
constexpr std::array<TrialCycle, 5> kTrialCycles{{{.25, .12, 2.5, 60, false},
                                                  {.2, .09, 1, 20, false},
                                                  {.12, .05, .5, 4, true},
                                                  {.1, .04, .25, 1, true},
                                                  {.06, .02, .2, .2, true}}};

class Cleaner {
 public:
  Cleaner(QuadWork& work, int split_growth)
      : work_(work), smoother_(work), split_growth_(split_growth) {}

  CleanStatistics statistics;

  /// Tries the operations at every quadrilateral of the list, worst first. Returns how many were
  /// kept.
  std::int64_t pass(std::vector<Index> quads, double threshold) {
    const std::int64_t before = statistics.operations;
    std::sort(quads.begin(), quads.end(), [&](Index x, Index y) {
      return work_.energy[x] > work_.energy[y] || (work_.energy[x] == work_.energy[y] && x < y);
    });
    tried_at_.resize(work_.mesh.quad_count(), 0);
    for (const Index quad : quads) {
      if (quad >= work_.mesh.quad_count() || work_.mesh.is_dead(quad)) continue;
      if (work_.energy[quad] <= threshold || !changed_since_trial(quad)) continue;
      desperate_ = work_.energy[quad] > kDesperate;
      const bool changed = try_all(quad);
      if (static_cast<Index>(tried_at_.size()) < work_.mesh.quad_count())
        tried_at_.resize(work_.mesh.quad_count(), 0);
      if (!changed) tried_at_[quad] = work_.commits();
    }
    return statistics.operations - before;
  }

 private:
  static constexpr double kDesperate = 2.5;

  bool changed_since_trial(Index quad) const {
    std::uint32_t last = 0;
    for (int k = 0; k < 4; ++k)
      last = std::max(last, work_.changed_at[work_.mesh.corner[4 * quad + k]]);
    return last > tried_at_[quad];
  }

  bool try_all(Index quad) {
    const Index first = 4 * quad;
    return kept(collapse_diagonal(work_, first)) || kept(collapse_diagonal(work_, first + 1)) ||
           try_edges(first) || try_splits(first) || try_vertices(first) ||
           (!work_.convex[quad] && kept(inset_quad(work_, quad)));
  }

  bool try_edges(Index first) {
    for (int k = 0; k < 4; ++k)
      for (int steps = 1; steps <= 2; ++steps)
        if (kept(rotate_edge(work_, first + k, steps))) return true;
    return false;
  }

  bool try_splits(Index first) {
    for (int k = 0; k < 4; ++k)
      if (try_splits_of(work_.mesh.corner[first + k])) return true;
    return false;
  }

  bool try_splits_of(Index v) {
    const QuadMesh& mesh = work_.mesh;
    const int valence = mesh.valence[v];
    if (mesh.on_boundary(v)) {
      for (int begin = 0; begin < valence; ++begin)
        for (int end = begin + 2; end <= valence; ++end)
          if (kept(split_boundary_vertex(work_, v, begin, end))) return true;
      return false;
    }
    if (!mesh.is_free(v) || valence < 4) return false;
    // The two halves are alike when the valence is even.
    const int starts = valence % 2 ? valence : valence / 2;
    for (int i = 0; i < starts; ++i) {
      Index h = mesh.leaving[v];
      for (int k = 0; k < i; ++k) h = anticlockwise(mesh, h);
      if (kept(split_vertex(work_, h, valence / 2), split_growth_)) return true;
    }
    return false;
  }

  bool try_vertices(Index first) {
    for (int k = 0; k < 4; ++k)
      if (kept(rotate_vertex(work_, work_.mesh.corner[first + k]), split_growth_)) return true;
    return false;
  }

  /// Judges the transaction that is open when `done`; commits or undoes it.
  bool kept(bool done, int most_growth = 2) {
    if (!done) return false;
    if (!desperate_ && work_.valence_growth() > most_growth) return undone();
    ++statistics.trials;
    return lowers_energy() ? committed() : undone();
  }

  bool undone() {
    work_.undo();
    return false;
  }

  bool committed() {
    work_.commit();
    ++statistics.operations;
    return true;
  }

  /// Smooths around the change, cycle by cycle, as long as there is hope.
  bool lowers_energy() {
    constexpr double kGain = -1e-3, kUnmoved = 0.02, kHopeless = 60;
    int not_convex = 0;
    double change = work_.energy_change(not_convex);
    if (change > kHopeless && !desperate_) return false;
    const std::vector<Index> vertices = work_.free_vertices();
    double previous = change;
    for (std::size_t c = 0; c < kTrialCycles.size(); ++c) {
      const TrialCycle& cycle = kTrialCycles[c];
      smooth(vertices, {cycle.first_step, cycle.last_step, cycle.repeat});
      change = work_.energy_change(not_convex);
      if (change < kGain && not_convex <= 0) return true;
      if (not_convex < 0 && c + 1 == kTrialCycles.size()) return true;  // at any price
      if (not_convex < 0) continue;
      if (change > (desperate_ ? cycle.reject_desperate : cycle.reject)) return false;
      if (c >= 2 && previous - change < kUnmoved) return false;
      previous = change;
    }
    return false;
  }

  void smooth(const std::vector<Index>& vertices, const SearchOptions& options) {
    WorkVertex better;
    for (const Index v : vertices)
      if (work_.mesh.leaving[v] != kNoIndex && smoother_.improve(v, options, better))
        work_.move(v, better);
  }

  QuadWork& work_;
  QuadSmoother smoother_;
  int split_growth_;  ///< most growth of the valence defect by splits and turned vertices
  std::vector<std::uint32_t> tried_at_;  ///< per quad: commits when it was last tried in vain
  bool desperate_ = false;
};

std::vector<Index> bad_quads(const QuadWork& work, double threshold) {
  std::vector<Index> quads;
  for (Index q = 0; q < work.mesh.quad_count(); ++q)
    if (!work.mesh.is_dead(q) && work.energy[q] > threshold) quads.push_back(q);
  return quads;
}

std::vector<Index> changed_since(const QuadWork& work, std::uint32_t commits) {
  std::vector<Index> vertices;
  for (Index v = 0; v < static_cast<Index>(work.changed_at.size()); ++v)
    if (work.changed_at[v] > commits && work.mesh.leaving[v] != kNoIndex) vertices.push_back(v);
  return vertices;
}

}  // namespace

CleanStatistics clean(QuadWork& work, const CleanOptions& options, const Monitor& monitor) {
  Cleaner cleaner(work, 0);
  smooth_all(work, options.first_sweeps, {.first_step = 0.3, .last_step = 0.05});
  for (int pass = 0; pass < options.most_passes; ++pass) {
    monitor.report("quads", static_cast<double>(pass) / options.most_passes);
    const std::uint32_t before = work.commits();
    const std::int64_t kept = cleaner.pass(bad_quads(work, options.threshold), options.threshold);
    smooth_some(work, changed_since(work, before), 2, {.first_step = 0.1, .last_step = 0.03});
    if (kept < 2) break;
  }
  smooth_all(work, options.last_sweeps, {.first_step = 0.1, .last_step = 0.01});
  return cleaner.statistics;
}

namespace {

/// Metric length by Simpson's rule.
double edge_length_of(const QuadWork& work, Index h) {
  const WorkVertex& a = work.mesh.vertex_at(h);
  const WorkVertex& b = work.mesh.vertex_at(next_in_quad(h));
  const Vector u = b.p - a.p;
  Index hint = a.hint;
  const MetricFactor middle = work.background.factor_at(0.5 * (a.p + b.p), hint);
  return simpson_length(squared_length(a.r, u), squared_length(middle, u), squared_length(b.r, u));
}

bool wants_polish(const QuadWork& work, Index quad) {
  constexpr double kLeastBeta = 0.4, kShortest = 0.7, kLongest = 1.42;
  if (work.beta_of(quad) < kLeastBeta) return true;
  for (Index h = 4 * quad; h < 4 * quad + 4; ++h) {
    if (work.mesh.twin[h] < 0) continue;
    const double l = edge_length_of(work, h);
    if (l < kShortest || l > kLongest) return true;
  }
  return false;
}

void sort_out(std::vector<Index>& indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

/// Vertices of those of the quadrilaterals that want polish.
std::vector<Index> polish_vertices(const QuadWork& work, const std::vector<Index>& quads) {
  std::vector<Index> vertices;
  for (const Index q : quads) {
    if (work.mesh.is_dead(q) || !wants_polish(work, q)) continue;
    for (int k = 0; k < 4; ++k) vertices.push_back(work.mesh.corner[4 * q + k]);
  }
  sort_out(vertices);
  return vertices;
}

/// The quadrilaterals at the vertices.
std::vector<Index> quads_around(const QuadMesh& mesh, const std::vector<Index>& vertices) {
  std::vector<Index> quads;
  for (const Index v : vertices)
    if (mesh.leaving[v] != kNoIndex)
      for_each_leaving(mesh, v, [&](Index h) { quads.push_back(quad_of(h)); });
  sort_out(quads);
  return quads;
}

/// The corners of the quadrilaterals at the vertices.
std::vector<Index> grown(const QuadMesh& mesh, const std::vector<Index>& vertices) {
  std::vector<Index> result;
  for (const Index q : quads_around(mesh, vertices))
    for (int k = 0; k < 4; ++k) result.push_back(mesh.corner[4 * q + k]);
  sort_out(result);
  return result;
}

}  // namespace

CleanStatistics polish(QuadWork& work) {
  constexpr int kRounds = 4;
  constexpr double kThreshold = 0.4;
  work.weights.length = 0.6;
  work.weights.shape2 = 0.1;
  work.weights.middle_lengths = true;
  work.update_all_energies();
  Cleaner cleaner(work, 2);
  std::vector<Index> looked_at(work.mesh.quad_count());
  std::iota(looked_at.begin(), looked_at.end(), 0);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Index> targets = polish_vertices(work, looked_at);
    smooth_some(work, targets, 3, {.first_step = 0.1, .last_step = 0.02});
    // Only around these anything has changed.
    looked_at = quads_around(work.mesh, grown(work.mesh, targets));
    const std::uint32_t before = work.commits();
    const std::vector<Index> bad = quads_around(work.mesh, polish_vertices(work, looked_at));
    const auto kept = cleaner.pass(bad, kThreshold);
    targets = changed_since(work, before);
    const std::vector<Index> more = quads_around(work.mesh, grown(work.mesh, targets));
    looked_at.insert(looked_at.end(), more.begin(), more.end());
    sort_out(looked_at);
    smooth_some(work, polish_vertices(work, looked_at), 2, {.first_step = 0.08, .last_step = 0.02});
    if (kept == 0 && round > 0) break;
  }
  return cleaner.statistics;
}

}  // namespace anisofront
