#include "mesher/enhance/repair.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "mesher/enhance/collapse.hpp"
#include "mesher/enhance/smooth.hpp"
#include "mesher/enhance/split.hpp"
#include "mesher/enhance/swap.hpp"

namespace anisofront {
namespace {

/// What lies around a bad triangle, with copies, so that trial operations can be undone. `core` are
/// the triangles that touch the bad one, `movable` their vertices, `all` the triangles around
/// those: no operation on the bad triangle followed by smoothing of `movable` reaches further.
class Neighbourhood {
 public:
  Neighbourhood(Patch& patch, Index triangle) : patch_(patch) {
    const auto& v = patch.mesh.triangles[triangle].vertices;
    const std::vector<Index> core = triangles_around({v.begin(), v.end()}, {triangle});
    movable_ = vertices_of(core);
    all_ = triangles_around(movable_, core);
    const std::vector<Index> saved = with_neighbours(all_);
    for (const Index v1 : vertices_of(saved)) vertices_.push_back({v1, save_vertex(v1)});
    for (const Index t : saved)
      triangles_.push_back({t, {patch.mesh.triangles[t], patch.alpha[t]}});
    vertex_count_ = patch.mesh.vertices.size();
    triangle_count_ = patch.mesh.triangles.size();
    statistics_ = patch.statistics;
  }

  void restore() {
    patch_.mesh.vertices.resize(vertex_count_);
    patch_.triangle_of.resize(vertex_count_);
    patch_.fixed.resize(vertex_count_);
    patch_.active.resize(vertex_count_);
    patch_.mesh.triangles.resize(triangle_count_);
    patch_.alpha.resize(triangle_count_);
    for (const auto& [v, saved] : vertices_) {
      patch_.mesh.vertices[v] = saved.vertex;
      patch_.triangle_of[v] = saved.triangle;
    }
    for (const auto& [t, saved] : triangles_) {
      patch_.mesh.triangles[t] = saved.triangle;
      patch_.alpha[t] = saved.alpha;
    }
    patch_.statistics = statistics_;
  }

  /// Movable vertices and those added since.
  std::vector<Index> smoothing_set() const {
    std::vector<Index> set = movable_;
    for (std::size_t v = vertex_count_; v < patch_.mesh.vertices.size(); ++v)
      set.push_back(static_cast<Index>(v));
    return set;
  }

  /// Shape and length energy (see VertexEnergy) of all triangles here, those added since included.
  double energy() const {
    double sum = 0;
    for (const Index t : all_) sum += energy_of(t);
    for (std::size_t t = triangle_count_; t < patch_.mesh.triangles.size(); ++t)
      sum += energy_of(static_cast<Index>(t));
    return sum;
  }

  void update_alphas() {
    for (const Index t : all_)
      if (!patch_.mesh.triangles[t].dead()) patch_.update_alpha(t);
    for (std::size_t t = triangle_count_; t < patch_.mesh.triangles.size(); ++t)
      patch_.update_alpha(static_cast<Index>(t));
  }

 private:
  struct SavedVertex {
    WorkVertex vertex;
    Index triangle;
  };
  struct SavedTriangle {
    WorkTriangle triangle;
    float alpha;
  };

  SavedVertex save_vertex(Index v) const {
    return {patch_.mesh.vertices[v], patch_.triangle_of[v]};
  }

  static void sort_unique(std::vector<Index>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  std::vector<Index> vertices_of(const std::vector<Index>& triangles) const {
    std::vector<Index> list;
    for (const Index t : triangles)
      for (const Index v : patch_.mesh.triangles[t].vertices) list.push_back(v);
    sort_unique(list);
    return list;
  }

  /// The triangles and those across their edges: fans above the capacity of a ring are not listed.
  std::vector<Index> with_neighbours(std::vector<Index> list) const {
    const std::size_t count = list.size();
    for (std::size_t i = 0; i < count; ++i)
      for (const Index n : patch_.mesh.triangles[list[i]].neighbours)
        if (n >= 0) list.push_back(n);
    sort_unique(list);
    return list;
  }

  /// The triangles around the vertices; `known` holds one of each fan that matters.
  std::vector<Index> triangles_around(const std::vector<Index>& vertices,
                                      const std::vector<Index>& known) const {
    std::vector<Index> list;
    Ring ring;
    for (const Index v : vertices) {
      for (const Index t : known) {
        const auto& w = patch_.mesh.triangles[t].vertices;
        if (w[0] != v && w[1] != v && w[2] != v) continue;
        if (fan_through(patch_, v, t, ring))
          list.insert(list.end(), ring.triangles.begin(), ring.triangles.begin() + ring.size);
        if (!patch_.fixed[v]) break;  // one ring; on segments there may be several fans
      }
    }
    list.insert(list.end(), known.begin(), known.end());
    sort_unique(list);
    return list;
  }

  double energy_of(Index triangle) const {
    constexpr double kLengthWeight = 4.33;
    const WorkTriangle& t = patch_.mesh.triangles[triangle];
    if (t.dead()) return 0;
    const double alpha = patch_.alpha_of(triangle);
    if (alpha <= 0) return 1e30;
    double energy = 1 / (alpha * alpha * alpha) - 1;
    for (int k = 0; k < 3; ++k) {
      const double l =
          edge_length(patch_.vertex(t.vertices[kNext[k]]), patch_.vertex(t.vertices[kPrevious[k]]));
      const double stretch = l * l + 1 / (l * l) - 2;
      energy += 0.5 * kLengthWeight * stretch * stretch;
    }
    return energy;
  }

  Patch& patch_;
  std::vector<Index> movable_, all_;
  std::vector<std::pair<Index, SavedVertex>> vertices_;
  std::vector<std::pair<Index, SavedTriangle>> triangles_;
  std::size_t vertex_count_, triangle_count_;
  EnhanceStatistics statistics_;
};

/// Trial operations on one triangle: 0-2 swaps, 3-8 collapses, 9-11 splits.
constexpr int kOperations = 12;

/// Collapses are for edges below unit length, splits for edges above.
bool apply(Patch& patch, Index t, int operation) {
  constexpr double kAnyLength = 4, kAnyAlpha = 0.01;
  const int k = operation % 3;
  if (operation < 3) return force_swap(patch, t, k);
  const Index a = patch.mesh.triangles[t].vertices[kNext[k]];
  const Index b = patch.mesh.triangles[t].vertices[kPrevious[k]];
  const bool is_short = edge_length(patch.vertex(a), patch.vertex(b)) < 1;
  if (operation >= 9) return !is_short && force_split(patch, t, k);
  if (!is_short) return false;
  return operation < 6 ? collapse(patch, a, b, kAnyLength, kAnyAlpha)
                       : collapse(patch, b, a, kAnyLength, kAnyAlpha);
}

/// Energy after the operation and smoothing; infinity when it cannot be done or looks hopeless
/// after the first sweep.
double outcome(Patch& patch, Neighbourhood& around, Index t, int operation, double before) {
  constexpr int kFurtherSweeps = 3;
  constexpr double kHopeless = 3;
  if (!apply(patch, t, operation)) return std::numeric_limits<double>::infinity();
  const std::vector<Index> vertices = around.smoothing_set();
  smooth_vertices(patch, vertices, 1);
  if (around.energy() > before + kHopeless) return std::numeric_limits<double>::infinity();
  smooth_vertices(patch, vertices, kFurtherSweeps);
  return around.energy();
}

bool repair(Patch& patch, Index t) {
  constexpr double kLeastGain = 0.05;
  Neighbourhood around(patch, t);
  const double before = around.energy();
  double least = before - kLeastGain;
  int best = -1;
  for (int operation = 0; operation < kOperations; ++operation) {
    const double energy = outcome(patch, around, t, operation, before);
    if (energy < least) {
      least = energy;
      best = operation;
    }
    around.restore();
  }
  if (best < 0) return false;
  outcome(patch, around, t, best, before);
  around.update_alphas();
  return true;
}

}  // namespace

int repair_worst(Patch& patch, double bad_alpha, double bad_length) {
  // Each trial takes as long as meshing a hundred triangles: the worst come first, the rest wait.
  const std::size_t most = 200 + patch.mesh.triangles.size() / 2000;
  std::vector<std::pair<float, Index>> bad;
  for (Index t = 0; t < static_cast<Index>(patch.mesh.triangles.size()); ++t) {
    if (patch.mesh.triangles[t].dead()) continue;
    if (has_bad_edge(patch, t, bad_length))
      bad.push_back({0.f, t});
    else if (patch.alpha[t] < bad_alpha)
      bad.push_back({patch.alpha[t], t});
  }
  std::sort(bad.begin(), bad.end());
  if (bad.size() > most) bad.resize(most);
  int repaired = 0;
  for (const auto& [alpha, t] : bad)
    if (!patch.mesh.triangles[t].dead() &&
        (patch.alpha[t] < bad_alpha || has_bad_edge(patch, t, bad_length)))
      repaired += repair(patch, t);
  return repaired;
}

}  // namespace anisofront
