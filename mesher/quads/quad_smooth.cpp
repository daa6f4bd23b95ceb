#include "mesher/quads/quad_smooth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/quads/on_curve.hpp"

namespace anisofront {
namespace {

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
  fan_ = mesh.on_boundary(v);
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
  const double edge_weight = 0.5 * work_.weights.length;
  const double inverse_p = inverse_of(p.r);
  double sum = 0;
  for (int i = 0; i < size_ && sum < limit; ++i) {
    const QuadView& spoke = spokes_[i];
    const QuadShape shape = quad_shape(spoke, p.p, p.r, inverse_p);
    sum += shape_energy(shape.low, shape.high, shape.least, work_.weights, kNotConvex) +
           edge_weight * work_.edge_defect(p, {spoke.q, spoke.at_q});
  }
  if (fan_) sum += edge_weight * work_.edge_defect(p, {spokes_[size_ - 1].g, at_g_[size_ - 1]});
  return sum;
}

double QuadSmoother::attempt(Point p, Index hint, double limit) {
  constexpr double kNegligible = 1e-7;
  WorkVertex trial{p, {}, hint};
  trial.r = work_.background.factor_at(p, trial.hint);
  const double e = energy(trial, limit);
  if (e >= least_ - kNegligible) return e;
  least_ = e;
  best_ = trial;
  return e;
}

namespace {

constexpr double kNoLimit = 1e300;

/// Where the parabola through three energies at -step, 0 and step is lowest; a little beyond the
/// lower end where it is hardly curved.
double lowest(double behind, double here, double ahead, double step) {
  const double curvature = ahead + behind - 2 * here;
  const double slope = behind - ahead;
  if (curvature > 0.25 * std::fabs(slope)) return 0.5 * step * slope / curvature;
  return slope > 0 ? 1.5 * step : slope < 0 ? -1.5 * step : 0;
}

/// Whether a step of this length is worth repeating.
bool is_worth(double gain, double energy) { return gain >= 0.02 * energy && gain >= 1e-4; }

constexpr double kRefinement = 0.4;  ///< of the step
constexpr double kLeastGain = 1e-6;

}  // namespace

bool QuadSmoother::improve(Index v, const SearchOptions& options, WorkVertex& better) {
  if (!load(v)) return false;
  best_ = work_.mesh.vertices[v];
  const double before = least_ = energy(best_, kNoLimit);
  if (options.ideal_point) attempt(ideal_point(), best_.hint, least_);
  for (double step = options.first_step; step >= options.last_step;) {
    const WorkVertex base = best_;
    const double here = least_;
    const auto along = [&](Vector direction) {  // an axis of the metric
      const Vector d = unscaled(base.r, step * direction);
      const double ahead = attempt(base.p + d, base.hint, kNoLimit);
      const double behind = attempt(base.p - d, base.hint, kNoLimit);
      return lowest(behind, here, ahead, step);
    };
    const double x = along({1, 0}), y = along({0, 1});
    attempt(base.p + unscaled(base.r, {x, y}), base.hint, least_);
    if (!options.repeat || !is_worth(here - least_, here)) step *= kRefinement;
  }
  better = best_;
  return least_ < before - kLeastGain;
}

bool QuadSmoother::slide(Index v, const SearchOptions& options, WorkVertex& better,
                         double& parameter) {
  constexpr double kMargin = 0.1;  // of the way between the neighbours
  if (!load(v)) return false;
  const Segment& from = work_.segments[work_.tracks[v].before];
  const Segment& to = work_.segments[work_.tracks[v].after];
  const NurbsCurve& curve = work_.domain->curves[from.curve].curve;
  const Point a = work_.mesh.vertices[from.a].p, b = work_.mesh.vertices[to.b].p;
  best_ = work_.mesh.vertices[v];
  parameter = from.parameter_b;
  const double before = least_ = energy(best_, kNoLimit);
  const double low = std::lerp(from.parameter_a, to.parameter_b, kMargin);
  const double high = std::lerp(to.parameter_b, from.parameter_a, kMargin);
  const double speed = length(best_.r, derivatives(curve, parameter).first);
  if (!(speed > 0)) return false;
  const auto attempt_at = [&](double t) {
    t = std::clamp(t, low, high);
    const double earlier = least_;
    const double e = attempt(point_between(curve, t, a, b), best_.hint, kNoLimit);
    if (least_ < earlier) parameter = t;
    return e;
  };
  for (double step = options.first_step / speed; step * speed >= options.last_step;
       step *= kRefinement) {
    const double t = parameter, here = least_;
    const double ahead = attempt_at(t + step), behind = attempt_at(t - step);
    attempt_at(t + lowest(behind, here, ahead, step));
  }
  better = best_;
  return least_ < before - kLeastGain;
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

/// Moves v to a better place, if there is one; how far, in squared metric length.
double relocate(QuadWork& work, QuadSmoother& smoother, Index v, const SearchOptions& options) {
  WorkVertex better;
  double parameter = 0;
  const bool slides = work.may_slide(v);
  if (!(slides ? smoother.slide(v, options, better, parameter)
               : smoother.improve(v, options, better)))
    return 0;
  if (slides)
    work.segments[work.tracks[v].before].parameter_b =
        work.segments[work.tracks[v].after].parameter_a = parameter;
  const Vector move = better.p - work.mesh.vertices[v].p;
  work.mesh.vertices[v] = better;
  for_each_leaving(work.mesh, v, [&](Index h) { work.energy[quad_of(h)] = -1; });
  return squared_length(better.r, move);
}

bool may_move(const QuadWork& work, Index v) {
  return work.mesh.leaving[v] != kNoIndex && (work.mesh.is_free(v) || work.may_slide(v));
}

}  // namespace

void smooth_some(QuadWork& work, std::vector<Index> vertices, int sweeps,
                 const SearchOptions& options) {
  QuadSmoother smoother(work);
  const Index all = static_cast<Index>(work.mesh.vertices.size());
  std::vector<char> active(all, 0);
  for (const Index v : vertices) active[v] = 1;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    bool any = false;
    // From the second sweep on neighbours of what moved take part, also those not asked for.
    const Index count = sweep == 0 ? static_cast<Index>(vertices.size()) : all;
    for (Index i = 0; i < count; ++i) {
      const Index v = sweep == 0 ? vertices[i] : i;
      if (!active[v] || !may_move(work, v)) continue;
      active[v] = 0;
      if (relocate(work, smoother, v, options) < kNoticeable * kNoticeable) continue;
      activate_around(work.mesh, v, active);
      any = true;
    }
    if (!any) break;
  }
  for (Index q = 0; q < work.mesh.quad_count(); ++q)
    if (work.energy[q] < 0 && !work.mesh.is_dead(q)) work.update_energy(q);
}

void smooth_all(QuadWork& work, int sweeps, const SearchOptions& options) {
  std::vector<Index> all;
  for (Index v = 0; v < static_cast<Index>(work.mesh.vertices.size()); ++v)
    if (may_move(work, v)) all.push_back(v);
  smooth_some(work, std::move(all), sweeps, options);
}

}  // namespace anisofront
