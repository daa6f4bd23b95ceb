#include "mesher/front/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/front/boundary_parts.hpp"
#include "mesher/front/boundary_validity.hpp"
#include "mesher/front/curve_frame.hpp"
#include "mesher/front/parity.hpp"
#include "mesher/front/piece_cutter.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

std::string text(Point p) { return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")"; }

class Discretiser {
 public:
  Discretiser(const Domain& domain, const Mesh& old_mesh, const BackgroundMesh& background,
              const BoundaryOptions& options, std::int64_t max_segments, const Monitor& monitor)
      : domain_(domain),
        background_(background),
        options_(options),
        max_segments_(max_segments),
        monitor_(monitor),
        negligible_(1e3 * join_tolerance(background)),
        frame_(make_curve_frame(domain, join_tolerance(background), options.corner_angle, monitor)),
        cutter_(domain, old_mesh, background, options, static_cast<double>(max_segments), frame_) {}

  Boundary run() {
    boundary_.point_vertices = frame_.point_vertices;
    start_mesh();
    for (const CurvePiece& piece : frame_.pieces) {
      cuts_.push_back(cutter_.cut(piece, hint_));
      lay(static_cast<Index>(cuts_.size()) - 1);
    }
    refine();
    if (options_.even) make_even();
    warn_about_gaps();
    return std::move(boundary_);
  }

 private:
  /// Ends of curves that are nearer to each other are one point.
  static double join_tolerance(const BackgroundMesh& background) {
    return 1e-12 * norm(background.bounds().high - background.bounds().low);
  }

  const NurbsCurve& curve(Index c) const { return domain_.curves[c].curve; }
  const std::string& name(Index c) const { return domain_.curves[c].name; }

  Index add_vertex(Point p) {
    boundary_.mesh.vertices.push_back({p, background_.factor_at(p, hint_), hint_});
    return static_cast<Index>(boundary_.mesh.vertices.size()) - 1;
  }

  /// An empty mesh but for the vertices of the frame.
  void start_mesh() {
    boundary_.mesh = {};
    piece_of_segment_.clear();
    curve_segments_.assign(domain_.curves.size(), {});
    for (const Point p : frame_.vertices) add_vertex(p);
  }

  /// Adds the segments of a piece that has been cut.
  void lay(Index id) {
    const CurvePiece& piece = frame_.pieces[id];
    const std::vector<double>& t = cuts_[id];
    Index from = piece.start;
    for (std::size_t k = 1; k < t.size(); ++k) {
      const bool last = k + 1 == t.size();
      const Index to = last ? piece.end : add_vertex(evaluate(curve(piece.curve), t[k]));
      add_segment({from, to, piece.curve, k == 1 ? piece.t0 : t[k - 1], last ? piece.t1 : t[k],
                   frame_.sides[piece.curve].left, frame_.sides[piece.curve].right},
                  id);
      from = to;
    }
  }

  void add_segment(const Segment& segment, Index piece) {
    piece_of_segment_.push_back(piece);
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
    add_segment(second, piece_of_segment_[id]);
  }

  void refine() {
    if (options_.chord_height > 0) limit_chord_height();
    resolve_conflicts();
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

  /// First by one edge more or less on some pieces; where refinement has made numbers odd, by
  /// halving longest segments.
  void make_even() {
    std::vector<ParityLink> links = links_between_parts();
    if (odd_parts(parts_).empty()) return;
    std::vector<PieceCutter::Change> changes;
    for (std::size_t i = 0; i < links.size(); ++i) {
      changes.push_back(cutter_.cheapest_change(frame_.pieces[i], cuts_[i], hint_));
      links[i].cost = changes[i].cost;
    }
    for (const Index i : parity_changes(links))
      cuts_[i] = cutter_.cut_into(frame_.pieces[i], changes[i].count, hint_);
    start_mesh();
    for (Index i = 0; i < static_cast<Index>(cuts_.size()); ++i) lay(i);
    refine();
    while (halve_for_parity()) resolve_conflicts();
  }

  /// The parts, as the mesh is now, on both sides of each piece.
  std::vector<ParityLink> links_between_parts() {
    parts_ = find_parts(boundary_.mesh);
    std::vector<ParityLink> links(frame_.pieces.size());
    for (std::size_t s = 0; s < piece_of_segment_.size(); ++s) {
      const auto& [left, right] = parts_.of_segment[s];
      links[piece_of_segment_[s]] = {left, right, 0};
    }
    return links;
  }

  std::vector<Index> parity_changes(const std::vector<ParityLink>& links) const {
    return cheapest_parity_changes(links, parts_.count, odd_parts(parts_));
  }

  /// Halves the longest segments of some pieces so that all parts become even; false when they are.
  bool halve_for_parity() {
    std::vector<ParityLink> links = links_between_parts();
    std::vector<Index> longest(links.size(), kNoIndex);
    std::vector<double> length(links.size(), 0);
    for (std::size_t i = 0; i < piece_of_segment_.size(); ++i) {
      const Segment& s = boundary_.mesh.segments[i];
      const double l = edge_length(boundary_.mesh.vertices[s.a], boundary_.mesh.vertices[s.b]);
      const Index id = piece_of_segment_[i];
      if (l <= length[id]) continue;
      length[id] = l;
      longest[id] = static_cast<Index>(i);
    }
    for (std::size_t i = 0; i < links.size(); ++i) links[i].cost = 1 / length[i];
    const std::vector<Index> changes = parity_changes(links);
    for (const Index id : changes) halve(longest[id]);
    return !changes.empty();
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
  const BackgroundMesh& background_;
  const BoundaryOptions& options_;
  std::int64_t max_segments_;
  const Monitor& monitor_;
  double negligible_;  ///< distance from its curve at which an edge counts as the curve
  CurveFrame frame_;
  PieceCutter cutter_;
  Index hint_ = 0;
  std::vector<std::vector<double>> cuts_;  ///< per piece: parameters of its vertices
  std::vector<Index> piece_of_segment_;
  std::vector<std::vector<Index>> curve_segments_;
  BoundaryParts parts_;
  Boundary boundary_;
};

}  // namespace

Boundary discretise_boundary(const Domain& domain, const Mesh& old_mesh,
                             const BackgroundMesh& background, const BoundaryOptions& options,
                             std::int64_t max_segments, const Monitor& monitor) {
  return Discretiser(domain, old_mesh, background, options, max_segments, monitor).run();
}

}  // namespace anisofront
