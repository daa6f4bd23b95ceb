#include "mesher/front/advance.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/front/front.hpp"
#include "mesher/front/ideal_point.hpp"
#include "mesher/front/paper_formation.hpp"
#include "mesher/front/right_angle.hpp"
#include "mesher/front/visibility.hpp"
#include "mesher/geometry/predicates.hpp"

namespace anisofront {
namespace {

/// Squared distance, in a constant metric, from p to a front edge.
double squared_distance(const MetricFactor& r, Point p, const FrontEdge& edge) {
  const Vector u = edge.a - p, v = edge.b - p;
  const Vector a{r.a * u.x + r.b * u.y, r.c * u.y};
  const Vector b{r.a * v.x + r.b * v.y, r.c * v.y};
  const Vector w = b - a;
  const double ww = squared_norm(w);
  const double t = -dot(a, w);
  if (t <= 0) return squared_norm(a);
  if (t >= ww) return squared_norm(b);
  const double area = cross(a, w);
  return area * area / ww;
}

/// Half the width and height of the ball { v : v' M v <= radius^2 }.
Vector half_extent(const MetricFactor& r, double radius) {
  return {radius * std::sqrt(r.b * r.b + r.c * r.c) / (r.a * r.c), radius / r.c};
}

Box box_around(const FrontEdge& base, Point centre, Vector half) {
  return {{std::min({base.a.x, base.b.x, centre.x - half.x}),
           std::min({base.a.y, base.b.y, centre.y - half.y})},
          {std::max({base.a.x, base.b.x, centre.x + half.x}),
           std::max({base.a.y, base.b.y, centre.y + half.y})}};
}

/// An apex and how good the element would be.
struct Candidate {
  double mu;
  Apex apex;
  /// Best first; ties by vertex number, so that the order of the search does not matter.
  friend bool operator<(const Candidate& x, const Candidate& y) {
    return x.mu > y.mu || (x.mu == y.mu && x.apex.vertex < y.apex.vertex);
  }
};

/// One base segment after the other; the members are buffers reused from step to step.
class Advancer {
 public:
  Advancer(const BackgroundMesh& background, WorkMesh& mesh, const FrontOptions& options,
           double expected_triangles)
      : background_(background),
        mesh_(mesh),
        options_(options),
        front_(mesh, bounds_of(mesh), typical_size(background, expected_triangles),
               base_order(options, expected_triangles)),
        marks_(mesh.vertices.size(), 0) {
    marks_.reserve(mesh.vertices.capacity());
    near_.reserve(256);
    candidates_.reserve(64);
  }

  FrontStatistics run(double expected_triangles, const Monitor& monitor) {
    constexpr std::int64_t kReportEvery = 1 << 14;
    while (!front_.empty()) {
      step(front_.next_base());
      if (++statistics_.steps % kReportEvery == 0)
        monitor.report("front",
                       std::min(1., static_cast<double>(statistics_.steps) / expected_triangles));
    }
    return statistics_;
  }

 private:
  static BaseOrder base_order(const FrontOptions& options, double expected_triangles) {
    const bool large = expected_triangles >= options.class_order_from;
    return large && options.order == BaseOrder::metric_length ? BaseOrder::metric_class
                                                              : options.order;
  }

  /// Curved boundaries can reach beyond the background.
  static Box bounds_of(const WorkMesh& mesh) {
    Box box{mesh.vertices.front().p, mesh.vertices.front().p};
    for (const WorkVertex& v : mesh.vertices) box = enclosing(box, v.p);
    return box;
  }

  static double typical_size(const BackgroundMesh& background, double expected_triangles) {
    const Vector diagonal = background.bounds().high - background.bounds().low;
    return std::max(diagonal.x, diagonal.y) / std::sqrt(std::max(1., 0.5 * expected_triangles));
  }

  /// Steps (i)-(vii) for one base segment.
  void step(Index base_id) {
    const FrontEdge base = front_.edges()[base_id];
    const MetricFactor& ra = mesh_.vertices[base.va].r;
    const MetricFactor& rb = mesh_.vertices[base.vb].r;
    const MetricFactor mean{0.5 * (ra.a + rb.a), 0.5 * (ra.b + rb.b), 0.5 * (ra.c + rb.c)};
    Index apex = options_.formation == ElementFormation::fast ? fast_apex(base, base_id, mean)
                 : options_.formation == ElementFormation::right_angle
                     ? right_angle_apex(base, base_id)
                     : paper_apex(base, base_id);
    if (apex == kNoIndex) apex = visible_vertex(base, base_id, mean);
    front_.form_element(base_id, apex);
  }

  double mu(const FrontEdge& base, Point c, const MetricFactor& at_c) const {
    const WorkVertex& a = mesh_.vertices[base.va];
    const WorkVertex& b = mesh_.vertices[base.vb];
    if (options_.formation == ElementFormation::fast) return fast_mu(a, b, c, at_c);
    if (options_.formation == ElementFormation::right_angle) return right_angle_mu(a, b, c, at_c);
    return paper_mu(background_, a, b, {c, at_c, a.hint});
  }

  void search(const FrontEdge& base, Index base_id, const TrialPoint& trial) {
    const Vector half = half_extent(trial.r, options_.search_radius);
    searched_ = box_around(base, trial.p, half);
    front_.query(searched_, base_id, near_);
  }

  double squared_distance_to_front(const TrialPoint& trial) const {
    double least = 1e300;
    for (const Index id : near_)
      least = std::min(least, squared_distance(trial.r, trial.p, front_.edges()[id]));
    return least;
  }

  /// Calls visit(vertex, place) once for every end of the edges in near_ but those of the base.
  template <class Visit>
  void for_each_near_vertex(const FrontEdge& base, Visit&& visit) {
    ++stamp_;
    marks_[base.va] = marks_[base.vb] = stamp_;
    for (const Index id : near_) {
      const FrontEdge& edge = front_.edges()[id];
      for (const auto& [v, p] : {std::pair{edge.va, edge.a}, std::pair{edge.vb, edge.b}}) {
        if (marks_[v] == stamp_) continue;
        marks_[v] = stamp_;
        visit(v, p);
      }
    }
  }

  /// Step (iv): the front vertices inside the ellipse around the trial point.
  void collect_vertices(const FrontEdge& base, const TrialPoint& trial) {
    const double radius2 = options_.search_radius * options_.search_radius;
    candidates_.clear();
    for_each_near_vertex(base, [&](Index v, Point p) {
      if (!overlap({p, p}, searched_) || squared_length(trial.r, p - trial.p) > radius2 ||
          twice_area(base.a, base.b, p) <= 0)
        return;
      const double quality = mu(base, p, mesh_.vertices[v].r);
      if (quality > 0) candidates_.push_back({quality, {v, p}});
    });
  }

  void add_trial(const FrontEdge& base, const TrialPoint& trial) {
    if (!overlap({trial.p, trial.p}, searched_)) return;
    const double quality = mu(base, trial.p, trial.r);
    if (quality > 0) candidates_.push_back({quality, {kNoIndex, trial.p}});
  }

  /// Step (v): the best valid candidate, or kNoIndex. A new vertex is appended to the mesh.
  Index best_valid(const FrontEdge& base, const TrialPoint& trial) {
    std::sort(candidates_.begin(), candidates_.end());
    for (const Candidate& c : candidates_) {
      if (!is_valid_element(base, c.apex, front_.edges(), near_)) continue;
      return c.apex.vertex == kNoIndex ? append(trial) : c.apex.vertex;
    }
    return kNoIndex;
  }

  Index append(const TrialPoint& trial) {
    mesh_.vertices.push_back({trial.p, trial.r, trial.hint});
    front_.add_vertex();
    marks_.push_back(0);
    ++statistics_.new_vertices;
    return static_cast<Index>(mesh_.vertices.size()) - 1;
  }

  /// Steps (ii)-(vi) of preset best. Where the front is so near that no new vertex can be made, the
  /// metric at the trial point is not even looked up.
  Index fast_apex(const FrontEdge& base, Index base_id, const MetricFactor& mean) {
    // A trial point moves by less than this share of its distance when it is corrected.
    constexpr double kSafety = 0.7;
    constexpr double kMoved2 = 0.01;
    const WorkVertex a = mesh_.vertices[base.va], b = mesh_.vertices[base.vb];
    const double closeness2 = options_.closeness * options_.closeness;
    const Point middle = 0.5 * (base.a + base.b);
    TrialPoint trial{constant_metric_apex(mean, base.a, base.b), mean, a.hint};
    search(base, base_id, trial);
    double distance2 = squared_distance_to_front(trial);
    bool looked_up = false;
    if (distance2 >= kSafety * closeness2) {
      const Point first = trial.p;
      looked_up = true;
      trial.r = background_.factor_at(trial.p, trial.hint);
      correct_by_newton(background_, a, b, options_.newton_steps, trial);
      if (squared_length(trial.r, trial.p - first) > kMoved2) search(base, base_id, trial);
      distance2 = squared_distance_to_front(trial);
    }
    while (true) {
      collect_vertices(base, trial);
      if (looked_up && distance2 >= closeness2) add_trial(base, trial);
      const Index found = best_valid(base, trial);
      if (found != kNoIndex) return found;
      if (!contract(middle, 3 * options_.least_offset, trial)) return kNoIndex;
      looked_up = true;
      search(base, base_id, trial);
      distance2 = squared_distance_to_front(trial);
    }
  }

  /// Steps (iv) and (v) for one trial point.
  Index apex_near(const FrontEdge& base, Index base_id, const TrialPoint& trial) {
    search(base, base_id, trial);
    collect_vertices(base, trial);
    const double closeness2 = options_.closeness * options_.closeness;
    if (squared_distance_to_front(trial) >= closeness2) add_trial(base, trial);
    return best_valid(base, trial);
  }

  /// Steps (ii)-(vi) to the letter.
  Index paper_apex(const FrontEdge& base, Index base_id) {
    const WorkVertex a = mesh_.vertices[base.va], b = mesh_.vertices[base.vb];
    const PaperOffset offset = paper_offset(background_, a, b);
    TrialPoint trial = offset.best;
    do {
      const Index found = apex_near(base, base_id, trial);
      if (found != kNoIndex) return found;
    } while (contract(offset.midpoint, options_.least_offset, trial));
    return kNoIndex;
  }

  /// The same for half squares: above both ends of a leg before the point is contracted.
  Index right_angle_apex(const FrontEdge& base, Index base_id) {
    const WorkVertex a = mesh_.vertices[base.va], b = mesh_.vertices[base.vb];
    const RightAngleOffset offset = right_angle_offset(background_, a, b, options_.newton_steps);
    for (int k = 0; k < offset.count; ++k) {
      const Index found = apex_near(base, base_id, offset.trials[k]);
      if (found != kNoIndex) return found;
    }
    TrialPoint trial = offset.trials[0];
    while (contract(offset.midpoint, options_.least_offset, trial)) {
      const Index found = apex_near(base, base_id, trial);
      if (found != kNoIndex) return found;
    }
    return kNoIndex;
  }

  /// Eqn 24; false when the point has come too near to the base segment.
  bool contract(Point midpoint, double least_offset, TrialPoint& trial) {
    ++statistics_.contractions;
    trial.p = midpoint + 0.8 * (trial.p - midpoint);
    trial.r = background_.factor_at(trial.p, trial.hint);
    return length(trial.r, trial.p - midpoint) >= least_offset;
  }

  /// Step (vi): the best visible front vertex, searched in boxes that grow until one is found.
  Index visible_vertex(const FrontEdge& base, Index base_id, const MetricFactor& mean) {
    ++statistics_.fallbacks;
    const Point apex = constant_metric_apex(mean, base.a, base.b);
    const Vector offset = apex - 0.5 * (base.a + base.b);
    Vector half = half_extent(mean, 1);
    half = {std::max(half.x, std::fabs(offset.x)), std::max(half.y, std::fabs(offset.y))};
    const Vector whole = background_.bounds().high - background_.bounds().low;
    while (true) {
      const Box box{{std::min(base.a.x, base.b.x) - half.x, std::min(base.a.y, base.b.y) - half.y},
                    {std::max(base.a.x, base.b.x) + half.x, std::max(base.a.y, base.b.y) + half.y}};
      front_.query(box, base_id, near_);
      collect_in_box(base, box);
      const Index found = best_valid(base, {});
      if (found != kNoIndex) return found;
      if (half.x > 2 * whole.x && half.y > 2 * whole.y) break;
      half = 2 * half;
    }
    throw MeshingError("no vertex is visible from the front edge (" + std::to_string(base.a.x) +
                       ", " + std::to_string(base.a.y) + ") - (" + std::to_string(base.b.x) + ", " +
                       std::to_string(base.b.y) +
                       "): the boundary crosses or touches itself near there");
  }

  void collect_in_box(const FrontEdge& base, const Box& box) {
    candidates_.clear();
    for_each_near_vertex(base, [&](Index v, Point p) {
      if (overlap({p, p}, box) && orientation(base.a, base.b, p) > 0)
        candidates_.push_back({mu(base, p, mesh_.vertices[v].r), {v, p}});
    });
  }

  const BackgroundMesh& background_;
  WorkMesh& mesh_;
  const FrontOptions& options_;
  Front front_;
  std::vector<std::uint32_t> marks_;  ///< per vertex: last step that looked at it
  std::uint32_t stamp_ = 0;
  Box searched_;             ///< apices outside it cannot be judged by near_
  std::vector<Index> near_;  ///< the front edges that meet it
  std::vector<Candidate> candidates_;
  FrontStatistics statistics_;
};

}  // namespace

FrontOptions paper_front_options() {
  FrontOptions options;
  options.order = BaseOrder::physical_length;
  options.formation = ElementFormation::paper;
  options.closeness = 0.1;
  return options;
}

FrontOptions right_angle_front_options() {
  FrontOptions options;
  options.order = BaseOrder::age;
  options.formation = ElementFormation::right_angle;
  return options;
}

FrontStatistics advance_front(const BackgroundMesh& background, WorkMesh& mesh,
                              const FrontOptions& options, double expected_triangles,
                              const Monitor& monitor) {
  return Advancer(background, mesh, options, expected_triangles).run(expected_triangles, monitor);
}

}  // namespace anisofront
