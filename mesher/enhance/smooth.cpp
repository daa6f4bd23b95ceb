#include "mesher/enhance/smooth.hpp"

#include <algorithm>

#include "mesher/enhance/vertex_energy.hpp"

namespace anisofront {
namespace {

constexpr double kLeastGain = 1e-3;  ///< share of the energy a move must save

/// Metric at a new place of vertex x.
WorkVertex moved(const Patch& patch, const WorkVertex& x, Point p) {
  WorkVertex y{p, {}, x.hint};
  y.r = patch.background.factor_at(p, y.hint);
  return y;
}

class Smoother {
 public:
  Smoother(Patch& patch, const SmoothOptions& options)
      : patch_(patch), content_(options.content), moved2_(options.moved * options.moved) {}

  void visit(Index v) {
    if (!closed_ring(patch_, v, ring_)) return;
    energy_.load(patch_, ring_);
    const WorkVertex x = patch_.vertex(v);
    const double old_energy = energy_(x, 1e31);
    if (old_energy < content_ * ring_.size) return;
    Vector move = 0.5 * (energy_.length_proposal(x) + energy_.quality_proposal(x));
    for (const double shorter : {1., 0.4}) {
      move = shorter * move;
      const WorkVertex y = moved(patch_, x, x.p + move);
      const double limit = (1 - kLeastGain) * old_energy;
      if (energy_(y, limit) >= limit || !energy_.is_valid(y.p)) continue;
      accept(v, x, y);
      return;
    }
  }

 private:
  void accept(Index v, const WorkVertex& x, const WorkVertex& y) {
    patch_.mesh.vertices[v] = y;
    ++patch_.statistics.moves;
    if (squared_length(x.r, y.p - x.p) <= moved2_) return;
    patch_.active[v] = 1;
    for (int i = 0; i < ring_.size; ++i) patch_.active[ring_.vertices[i]] = 1;
  }

  Patch& patch_;
  double content_, moved2_;
  Ring ring_;
  VertexEnergy energy_;
};

/// Compass search in units of the metric; halves the step when no direction helps.
class PatternSearch {
 public:
  explicit PatternSearch(Patch& patch) : patch_(patch) {}

  bool visit(Index v) {
    constexpr double kFirstStep = 0.15, kLastStep = 0.03;
    if (!closed_ring(patch_, v, ring_)) return false;
    energy_.load(patch_, ring_);
    WorkVertex best = patch_.vertex(v);
    const double old_energy = energy_(best, 1e31);
    double energy = old_energy;
    for (double step = kFirstStep; step > kLastStep;)
      if (!improve(best, energy, step)) step *= 0.5;
    if (energy >= (1 - kLeastGain) * old_energy || !energy_.is_valid(best.p)) return false;
    patch_.mesh.vertices[v] = best;
    ++patch_.statistics.moves;
    for (int i = 0; i < ring_.size; ++i) patch_.update_alpha(ring_.triangles[i]);
    return true;
  }

 private:
  bool improve(WorkVertex& best, double& energy, double step) {
    constexpr double kNegligible = 1e-9;
    for (const Vector d : {Vector{step, 0}, Vector{-step, 0}, Vector{0, step}, Vector{0, -step}}) {
      const double y = d.y / best.r.c;
      const Vector move{(d.x - best.r.b * y) / best.r.a, y};
      const WorkVertex trial = moved(patch_, best, best.p + move);
      const double trial_energy = energy_(trial, energy);
      if (trial_energy >= energy - kNegligible) continue;
      best = trial;
      energy = trial_energy;
      return true;
    }
    return false;
  }

  Patch& patch_;
  Ring ring_;
  VertexEnergy energy_;
};

}  // namespace

void smooth_active(Patch& patch, const SmoothOptions& options) {
  Smoother smoother(patch, options);
  for (int sweep = 0; sweep < options.sweeps; ++sweep) {
    for (Index v = 0; v < static_cast<Index>(patch.mesh.vertices.size()); ++v) {
      if (!patch.active[v] || patch.fixed[v] || patch.triangle_of[v] == kNoIndex) continue;
      patch.active[v] = 0;
      smoother.visit(v);
    }
  }
}

void smooth_vertices(Patch& patch, const std::vector<Index>& vertices, int sweeps) {
  Smoother smoother(patch, {sweeps, 0, 0.05});
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const Index v : vertices)
      if (!patch.fixed[v] && patch.triangle_of[v] != kNoIndex) smoother.visit(v);
}

bool has_bad_edge(const Patch& patch, Index t, double bad_length) {
  const WorkTriangle& triangle = patch.mesh.triangles[t];
  for (int k = 0; k < 3; ++k) {
    if (triangle.neighbours[k] > t) continue;  // its neighbour looks at it
    const double l = edge_length(patch.vertex(triangle.vertices[kNext[k]]),
                                 patch.vertex(triangle.vertices[kPrevious[k]]));
    if (l > bad_length || l * bad_length < 1) return true;
  }
  return false;
}

int smooth_targeted(Patch& patch, double bad_alpha, double bad_length) {
  std::vector<Index> targets;
  std::vector<char> chosen(patch.mesh.vertices.size(), 0);
  for (Index t = 0; t < static_cast<Index>(patch.mesh.triangles.size()); ++t) {
    const WorkTriangle& triangle = patch.mesh.triangles[t];
    if (triangle.dead()) continue;
    if (patch.alpha[t] >= bad_alpha && !has_bad_edge(patch, t, bad_length)) continue;
    for (const Index v : triangle.vertices) {
      if (chosen[v] || patch.fixed[v]) continue;
      chosen[v] = 1;
      targets.push_back(v);
    }
  }
  PatternSearch search(patch);
  return static_cast<int>(
      std::count_if(targets.begin(), targets.end(), [&](Index v) { return search.visit(v); }));
}

}  // namespace anisofront
