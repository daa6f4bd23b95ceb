#include "mesher/quads/quad_smooth.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {
namespace {

constexpr std::array<Vector, 8> kDirections{{{1, 0},
                                             {-1, 0},
                                             {0, 1},
                                             {0, -1},
                                             {0.70710678118654752, 0.70710678118654752},
                                             {-0.70710678118654752, -0.70710678118654752},
                                             {0.70710678118654752, -0.70710678118654752},
                                             {-0.70710678118654752, 0.70710678118654752}}};

/// x with R x = y: a vector of length |y| in the metric.
Vector unscaled(const MetricFactor& r, Vector y) {
  const double x2 = y.y / r.c;
  return {(y.x - r.b * x2) / r.a, x2};
}

/// d turned by 90 degrees (anticlockwise for sign 1) in the metric, its length there brought to 1
/// but for a factor of 4/3 at most (Eqns 27b, 27c).
Vector turned(const MetricFactor& r, Vector d, double sign) {
  const Vector y{r.a * d.x + r.b * d.y, r.c * d.y};
  const double scale = sign / std::clamp(std::sqrt(squared_norm(y)), 0.75, 4. / 3);
  return unscaled(r, {-scale * y.y, scale * y.x});
}

}  // namespace

bool QuadSmoother::load(Index v) {
  const QuadMesh& mesh = work_.mesh;
  if (mesh.valence[v] > kMostSpokes) return false;
  size_ = 0;
  for_each_leaving(mesh, v, [&](Index h) {
    const WorkVertex& g = mesh.vertex_at(previous_in_quad(h));
    at_g_[size_] = g.r;
    spokes_[size_++] =
        quad_view(mesh.vertex_at(next_in_quad(h)), mesh.vertex_at(opposite_in_quad(h)), g);
  });
  return true;
}

Point QuadSmoother::ideal_point() const {
  Point sum{0, 0};
  for (int i = 0; i < size_; ++i) {
    const QuadView& s = spokes_[i];
    sum = sum + (s.q + turned(s.at_q, s.t - s.q, 1)) + (s.g + turned(at_g_[i], s.t - s.g, -1));
  }
  return (0.5 / size_) * sum;
}

double QuadSmoother::energy(const WorkVertex& p, double limit) const {
  constexpr double kNotConvex = 1e12;  // no gain in length is worth it
  const double inverse_p = inverse_of(p.r);
  double sum = 0;
  for (int i = 0; i < size_ && sum < limit; ++i) {
    const QuadView& spoke = spokes_[i];
    const QuadShape shape = quad_shape(spoke, p.p, p.r, inverse_p);
    // Each edge at p belongs to two of the quadrilaterals, a quarter of the weight in each.
    sum += shape_energy(shape.low, shape.high, shape.least, work_.weights, kNotConvex) +
           0.5 * work_.weights.length * work_.edge_defect(p, {spoke.q, spoke.at_q});
  }
  return sum;
}

WorkVertex QuadSmoother::placed(Point p, Index hint) const {
  WorkVertex vertex{p, {}, hint};
  vertex.r = work_.background.factor_at(p, vertex.hint);
  return vertex;
}

bool QuadSmoother::improve(Index v, const SearchOptions& options, WorkVertex& better) {
  constexpr double kNoLimit = 1e300, kNegligible = 1e-6;
  if (!load(v)) return false;
  better = work_.mesh.vertices[v];
  const double before = energy(better, kNoLimit);
  double least = before;
  const auto attempt = [&](Point p) {
    const WorkVertex trial = placed(p, better.hint);
    const double e = energy(trial, least);
    if (e >= least - 1e-7) return false;
    least = e;
    better = trial;
    return true;
  };
  const auto attempt_all = [&](Point p, Index hint, double& e) {
    const WorkVertex trial = placed(p, hint);
    e = energy(trial, kNoLimit);
    if (e >= least - 1e-7) return;
    least = e;
    better = trial;
  };
  if (options.ideal_point) attempt(ideal_point());
  for (double step = options.first_step; step >= options.last_step;) {
    const WorkVertex base = better;
    const double at_base = least;
    // Curvature along the two axes of the metric, then the lowest point of the parabolas.
    const auto along = [&](Vector direction) {
      const Vector d = unscaled(base.r, step * direction);
      double ahead = kNoLimit, behind = kNoLimit;
      attempt_all(base.p + d, base.hint, ahead);
      attempt_all(base.p - d, base.hint, behind);
      const double curvature = ahead + behind - 2 * at_base;
      const double slope = behind - ahead;
      if (!(curvature > std::fabs(slope) * 0.25))
        return slope > 0 ? 1.5 * step : slope < 0 ? -1.5 * step : 0.;
      return 0.5 * step * slope / curvature;
    };
    const Vector move{along({1, 0}), along({0, 1})};
    attempt(base.p + unscaled(base.r, move));
    const double gain = at_base - least;
    if (gain < 0.02 * at_base || gain < 1e-4 || !options.diagonals) step *= 0.4;
  }
  return least < before - kNegligible;
}

namespace {

/// Moves beyond this length make the neighbours worth another look.
constexpr double kNoticeable = 0.02;

void activate_around(const QuadMesh& mesh, Index v, std::vector<char>& active) {
  active[v] = 1;
  for_each_leaving(mesh, v, [&](Index h) {
    active[mesh.corner[next_in_quad(h)]] = 1;
    active[mesh.corner[opposite_in_quad(h)]] = 1;
  });
}

}  // namespace

void smooth_some(QuadWork& work, std::vector<Index> vertices, int sweeps,
                 const SearchOptions& options) {
  QuadMesh& mesh = work.mesh;
  QuadSmoother smoother(work);
  std::vector<char> active(mesh.vertices.size(), 0);
  for (const Index v : vertices) active[v] = 1;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    bool any = false;
    // From the second sweep on neighbours of what moved take part, also those not asked for.
    const Index count =
        sweep == 0 ? static_cast<Index>(vertices.size()) : static_cast<Index>(mesh.vertices.size());
    for (Index i = 0; i < count; ++i) {
      const Index v = sweep == 0 ? vertices[i] : i;
      if (!active[v] || !mesh.is_free(v) || mesh.leaving[v] == kNoIndex) continue;
      active[v] = 0;
      WorkVertex better;
      if (!smoother.improve(v, options, better)) continue;
      const Vector move = better.p - mesh.vertices[v].p;
      mesh.vertices[v] = better;
      for_each_leaving(mesh, v, [&](Index h) { work.energy[quad_of(h)] = -1; });
      if (squared_length(better.r, move) < kNoticeable * kNoticeable) continue;
      activate_around(mesh, v, active);
      any = true;
    }
    if (!any) break;
  }
  for (Index q = 0; q < mesh.quad_count(); ++q)
    if (work.energy[q] < 0 && !mesh.is_dead(q)) work.update_energy(q);
}

void smooth_all(QuadWork& work, int sweeps, const SearchOptions& options) {
  std::vector<Index> all;
  for (Index v = 0; v < static_cast<Index>(work.mesh.vertices.size()); ++v)
    if (work.mesh.leaving[v] != kNoIndex && work.mesh.is_free(v)) all.push_back(v);
  smooth_some(work, std::move(all), sweeps, options);
}

}  // namespace anisofront
