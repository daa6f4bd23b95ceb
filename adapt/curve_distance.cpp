#include "adapt/curve_distance.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "mesher/background/locality.hpp"

namespace anisofront {
namespace {

/// Newton steps on a gently bent edge, from the foot on its chord.
constexpr int kNewtonSteps = 8;
double distance(const Box& box, Point p) {
  const Vector beyond{std::max({box.low.x - p.x, p.x - box.high.x, 0.}),
                      std::max({box.low.y - p.y, p.y - box.high.y, 0.})};
  return norm(beyond);
}

Box united(const Box& a, const Box& b) { return enclosing(enclosing(a, b.low), b.high); }

}  // namespace

CurveDistance::CurveDistance(const FeMesh& fe, const std::vector<Index>& tags, double reach)
    : reach_(reach) {
  for (std::size_t i = 0; i < fe.mesh.edges.size(); ++i) {
    const CurveEdge& edge = fe.mesh.edges[i];
    if (std::find(tags.begin(), tags.end(), edge.tag) == tags.end()) continue;
    const Point a = fe.mesh.points[edge.vertices[0]], b = fe.mesh.points[edge.vertices[1]];
    const Index number = fe.edges.curve_edges[i];
    const bool is_bent = fe.edge_is_bent[number] != 0;
    const Vector bend = is_bent ? 4 * (fe.edge_points[number] - lerp(a, b, 0.5)) : Vector{};
    arcs_.push_back({a, b - a, bend, fe.curve_tangents[i], static_cast<Index>(i)});
  }
  if (arcs_.empty()) return;
  sort_arcs();
  boxes_.resize(2 * std::bit_ceil(arcs_.size()));
  build({0, 0, static_cast<Index>(arcs_.size())});
}

void CurveDistance::sort_arcs() {
  std::vector<Point> middles;
  for (const Arc& arc : arcs_) middles.push_back(arc.at(0.5));
  Box bounds{middles[0], middles[0]};
  for (const Point p : middles) bounds = enclosing(bounds, p);
  std::vector<Arc> sorted;
  for (const Index i : spatial_order(middles, bounds.low, bounds.high)) sorted.push_back(arcs_[i]);
  arcs_ = std::move(sorted);
}

Box CurveDistance::build(Range range) {
  Box& box = boxes_[range.node];
  return box = range.is_leaf() ? arcs_[range.begin].box()
                               : united(build(range.half(0)), build(range.half(1)));
}

/// Box of the ends and of the control point of the parabola.
Box CurveDistance::Arc::box() const {
  return enclosing(enclosing({a, a}, a + chord), a + 0.5 * (chord + bend));
}

double CurveDistance::Arc::nearest_parameter(Point p) const {
  double t = std::clamp(dot(p - a, chord) / squared_norm(chord), 0., 1.);
  if (bend == Vector{}) return t;
  for (int k = 0; k < kNewtonSteps; ++k) {
    const Vector offset = at(t) - p, velocity = chord + (1 - 2 * t) * bend;
    const double curvature = squared_norm(velocity) - 2 * dot(offset, bend);
    if (!(curvature > 0)) break;  // beyond the centre of curvature
    t = std::clamp(t - dot(offset, velocity) / curvature, 0., 1.);
  }
  return t;
}

void CurveDistance::search(Range range, Point p, Foot& best) const {
  if (distance(boxes_[range.node], p) > best.distance) return;
  if (range.is_leaf()) {
    const Arc& arc = arcs_[range.begin];
    const double t = arc.nearest_parameter(p), found = norm(arc.at(t) - p);
    const bool is_tie = best.arc != kNoIndex && found == best.distance;
    if (is_tie ? arc.number < arcs_[best.arc].number : found <= best.distance)
      best = {range.begin, t, found};
    return;
  }
  const Range low = range.half(0), high = range.half(1);
  const bool low_first = distance(boxes_[low.node], p) <= distance(boxes_[high.node], p);
  search(low_first ? low : high, p, best);
  search(low_first ? high : low, p, best);
}

std::optional<NearestOnCurves> CurveDistance::nearest(Point p) const {
  Foot foot{kNoIndex, 0, reach_};
  if (!arcs_.empty()) search({0, 0, static_cast<Index>(arcs_.size())}, p, foot);
  if (foot.arc == kNoIndex) return std::nullopt;
  const Arc& arc = arcs_[foot.arc];
  const Vector tangent = (1 - foot.t) * arc.tangents[0] + foot.t * arc.tangents[1];
  return NearestOnCurves{foot.distance, (1 / norm(tangent)) * tangent};
}

}  // namespace anisofront
