#include "mesher/front/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "mesher/front/boundary_validity.hpp"
#include "mesher/front/curve_frame.hpp"
#include "mesher/front/curve_profile.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/mesh/boundary_domain.hpp"

namespace anisofront {
namespace {

std::string text(Point p) { return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")"; }

class Discretiser {
 public:
  Discretiser(const Domain& domain, const Mesh& old_mesh, const BackgroundMesh& background,
              const BoundaryOptions& options, std::int64_t max_segments, const Monitor& monitor)
      : domain_(domain),
        old_mesh_(old_mesh),
        background_(background),
        options_(options),
        max_segments_(max_segments),
        monitor_(monitor),
        curve_segments_(domain.curves.size()) {
    const Vector diagonal = background.bounds().high - background.bounds().low;
    const double tolerance = 1e-12 * norm(diagonal);
    negligible_ = 1e3 * tolerance;
    frame_ = make_curve_frame(domain, tolerance, monitor);
  }

  Boundary run() {
    for (const Point p : frame_.vertices) add_vertex(p);
    boundary_.point_vertices = frame_.point_vertices;
    collect_old_edges();
    for (const CurvePiece& piece : frame_.pieces) cut(piece, profile_of(piece));
    if (options_.chord_height > 0) limit_chord_height();
    resolve_conflicts();
    warn_about_gaps();
    return std::move(boundary_);
  }

 private:
  const NurbsCurve& curve(Index c) const { return domain_.curves[c].curve; }
  const std::string& name(Index c) const { return domain_.curves[c].name; }

  Index add_vertex(Point p) {
    boundary_.mesh.vertices.push_back({p, background_.factor_at(p, hint_), hint_});
    return static_cast<Index>(boundary_.mesh.vertices.size()) - 1;
  }

  /// Edges of the old mesh by curve, each and all in the direction of the parameter.
  void collect_old_edges() {
    if (!options_.over_old_segments) return;
    old_edges_.resize(domain_.curves.size());
    for (CurveEdge edge : old_mesh_.edges) {
      if (edge.curve < 0 || edge.curve >= static_cast<Index>(old_edges_.size()) ||
          crosses_seam(curve(edge.curve), edge.parameters))
        continue;
      if (edge.parameters[0] > edge.parameters[1]) {
        std::swap(edge.parameters[0], edge.parameters[1]);
        std::swap(edge.vertices[0], edge.vertices[1]);
      }
      old_edges_[edge.curve].push_back(edge);
    }
    for (auto& edges : old_edges_)
      std::sort(edges.begin(), edges.end(), [](const CurveEdge& e, const CurveEdge& f) {
        return e.parameters[0] < f.parameters[0];
      });
  }

  /// The old edges that cover the piece without gaps, or nothing.
  std::vector<CurveEdge> old_edges_of(const CurvePiece& piece) const {
    if (!options_.over_old_segments) return {};
    const double slack = 1e-9 * (piece.t1 - piece.t0);
    std::vector<CurveEdge> edges;
    double reached = piece.t0;
    for (const CurveEdge& edge : old_edges_[piece.curve]) {
      if (edge.parameters[1] <= piece.t0 + slack || edge.parameters[0] >= piece.t1 - slack)
        continue;
      if (std::fabs(edge.parameters[0] - reached) > slack) return {};
      reached = edge.parameters[1];
      edges.push_back(edge);
    }
    if (std::fabs(reached - piece.t1) > slack) return {};
    return edges;
  }

  CurveProfile profile_of(const CurvePiece& piece) {
    const std::vector<CurveEdge> old_edges = old_edges_of(piece);
    if (!old_edges.empty()) return measure_old_segments(background_, old_mesh_, old_edges, hint_);
    return sample_curve(background_, curve(piece.curve), piece.t0, piece.t1, options_.sample_length,
                        static_cast<double>(max_segments_), hint_);
  }

  std::vector<double> cut_parameters(const CurvePiece& piece, const CurveProfile& profile) {
    const Index least = piece.start == piece.end ? 3 : 1;  // a closed curve needs three edges
    if (options_.over_old_segments || is_straight(curve(piece.curve)))
      return equal_parts(profile, std::max(segment_count(profile.total()), least));
    return equal_chords(background_, curve(piece.curve), profile, least, hint_);
  }

  static bool is_straight(const NurbsCurve& c) {
    const Point a = c.points.front(), b = c.points.back();
    const double scale = norm(b - a);
    if (scale == 0) return false;  // closed
    return std::all_of(c.points.begin(), c.points.end(), [&](Point p) {
      return std::fabs(twice_area(a, b, p)) <= 1e-12 * scale * scale && dot(p - a, b - a) >= 0 &&
             dot(p - b, a - b) >= 0;
    });
  }

  void cut(const CurvePiece& piece, const CurveProfile& profile) {
    const std::vector<double> t = cut_parameters(piece, profile);
    Index from = piece.start;
    for (std::size_t k = 1; k < t.size(); ++k) {
      const bool last = k + 1 == t.size();
      const Index to = last ? piece.end : add_vertex(evaluate(curve(piece.curve), t[k]));
      add_segment({from, to, piece.curve, k == 1 ? piece.t0 : t[k - 1], last ? piece.t1 : t[k],
                   frame_.sides[piece.curve].left, frame_.sides[piece.curve].right});
      from = to;
    }
  }

  void add_segment(const Segment& segment) {
    curve_segments_[segment.curve].push_back(static_cast<Index>(boundary_.mesh.segments.size()));
    boundary_.mesh.segments.push_back(segment);
    if (static_cast<std::int64_t>(boundary_.mesh.segments.size()) > max_segments_)
      throw BudgetError("the boundary needs more than " + std::to_string(max_segments_) +
                        " edges; ask for larger sizes or allow more nodes");
  }

  /// Largest distance, at three inner points, between a segment and its curve.
  double chord_error(const Segment& s) const {
    const Point a = boundary_.mesh.vertices[s.a].p, b = boundary_.mesh.vertices[s.b].p;
    const double chord = norm(b - a);
    double error = 0;
    for (const double f : {0.25, 0.5, 0.75}) {
      const Point p = evaluate(curve(s.curve), std::lerp(s.parameter_a, s.parameter_b, f));
      error = std::max(error, chord > 0 ? std::fabs(twice_area(a, b, p)) / chord : norm(p - a));
    }
    return error;
  }

  void halve(Index id) {
    Segment& s = boundary_.mesh.segments[id];
    const double t = 0.5 * (s.parameter_a + s.parameter_b);
    hint_ = boundary_.mesh.vertices[s.a].hint;
    const Index middle = add_vertex(evaluate(curve(s.curve), t));
    Segment second = s;
    s.b = second.a = middle;
    s.parameter_b = second.parameter_a = t;
    add_segment(second);
  }

  void limit_chord_height() {
    for (std::size_t i = 0; i < boundary_.mesh.segments.size(); ++i)
      while (chord_error(boundary_.mesh.segments[i]) > options_.chord_height)
        halve(static_cast<Index>(i));
  }

  bool can_refine(Index id) const {
    const Segment& s = boundary_.mesh.segments[id];
    return chord_error(s) > negligible_;
  }

  void resolve_conflicts() {
    constexpr int kRounds = 40;
    for (int round = 0;; ++round) {
      std::vector<Index> refine;
      for (const SegmentConflict& conflict : find_conflicts(boundary_.mesh)) {
        const bool first = can_refine(conflict.first), second = can_refine(conflict.second);
        if ((!first && !second) || round == kRounds) refuse(conflict);
        if (first) refine.push_back(conflict.first);
        if (second) refine.push_back(conflict.second);
      }
      if (refine.empty()) add_badly_nested(refine);
      if (refine.empty()) return;
      std::sort(refine.begin(), refine.end());
      refine.erase(std::unique(refine.begin(), refine.end()), refine.end());
      for (const Index id : refine) halve(id);
    }
  }

  [[noreturn]] void refuse(const SegmentConflict& conflict) const {
    const Index c = boundary_.mesh.segments[conflict.first].curve;
    const Index d = boundary_.mesh.segments[conflict.second].curve;
    if (c == d)
      throw InputError("curve \"" + name(c) + "\" crosses or touches itself near " +
                       text(conflict.place) + "; split it or move its points");
    throw InputError("curves \"" + name(c) + "\" and \"" + name(d) + "\" cross or touch near " +
                     text(conflict.place) +
                     "; let them end in a common point there or move them apart");
  }

  std::vector<Index> segments_of(const Loop& loop) const {
    std::vector<Index> ids;
    for (const CurveUse& use : loop)
      ids.insert(ids.end(), curve_segments_[use.curve].begin(), curve_segments_[use.curve].end());
    return ids;
  }

  /// Holes that a too coarse outer loop leaves outside: its curved segments must be refined.
  void add_badly_nested(std::vector<Index>& refine) const {
    for (const DomainRegion& region : domain_.regions) {
      if (region.loops.size() < 2) continue;
      const std::vector<Index> outer = segments_of(region.loops[0]);
      for (std::size_t k = 1; k < region.loops.size(); ++k) {
        const Index c = region.loops[k].front().curve;
        const Segment& s = boundary_.mesh.segments[curve_segments_[c].front()];
        if (is_inside(boundary_.mesh, outer, boundary_.mesh.vertices[s.a].p)) continue;
        const std::size_t before = refine.size();
        for (const Index id : outer)
          if (can_refine(id)) refine.push_back(id);
        if (refine.size() == before)
          throw InputError("hole \"" + name(c) + "\" lies outside region \"" + region.name + "\"");
      }
    }
  }

  void warn_about_gaps() const {
    constexpr double kNarrow = 0.05;
    const auto gap = find_narrow_gap(boundary_.mesh, kNarrow);
    if (!gap) return;
    const Index c = boundary_.mesh.segments[gap->first].curve;
    const Index d = boundary_.mesh.segments[gap->second].curve;
    monitor_.warning("curves \"" + name(c) + "\" and \"" + name(d) + "\" come closer than " +
                     "a twentieth of the wanted size near " + text(gap->place) +
                     "; elements there will be thin, ask for a smaller size");
  }

  const Domain& domain_;
  const Mesh& old_mesh_;
  const BackgroundMesh& background_;
  const BoundaryOptions& options_;
  std::int64_t max_segments_;
  const Monitor& monitor_;
  double negligible_;  ///< distance from its curve at which an edge counts as the curve
  CurveFrame frame_;
  Index hint_ = 0;
  std::vector<std::vector<CurveEdge>> old_edges_;
  std::vector<std::vector<Index>> curve_segments_;
  Boundary boundary_;
};

}  // namespace

Boundary discretise_boundary(const Domain& domain, const Mesh& old_mesh,
                             const BackgroundMesh& background, const BoundaryOptions& options,
                             std::int64_t max_segments, const Monitor& monitor) {
  return Discretiser(domain, old_mesh, background, options, max_segments, monitor).run();
}

}  // namespace anisofront
