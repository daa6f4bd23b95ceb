#include "mesher/front/piece_cutter.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/mesh/boundary_domain.hpp"

namespace anisofront {
namespace {

bool is_straight(const NurbsCurve& c) {
  const Point a = c.points.front(), b = c.points.back();
  const double scale = norm(b - a);
  if (scale == 0) return false;  // closed
  return std::all_of(c.points.begin(), c.points.end(), [&](Point p) {
    return std::fabs(twice_area(a, b, p)) <= 1e-12 * scale * scale && dot(p - a, b - a) >= 0 &&
           dot(p - b, a - b) >= 0;
  });
}

}  // namespace

PieceCutter::PieceCutter(const Domain& domain, const Mesh& old_mesh,
                         const BackgroundMesh& background, const BoundaryOptions& options,
                         double max_length, const CurveFrame& frame)
    : domain_(domain),
      old_mesh_(old_mesh),
      background_(background),
      options_(options),
      max_length_(max_length),
      frame_(frame),
      pieces_of_vertex_(frame.vertices.size(), 0) {
  for (const CurvePiece& piece : frame.pieces)
    for (const Index v : {piece.start, piece.end}) ++pieces_of_vertex_[v];
  if (options.over_old_segments) collect_old_edges();
}

/// Edges of the old mesh by curve, each and all in the direction of the parameter.
void PieceCutter::collect_old_edges() {
  old_edges_.resize(domain_.curves.size());
  for (CurveEdge edge : old_mesh_.edges) {
    if (edge.curve < 0 || edge.curve >= static_cast<Index>(old_edges_.size()) ||
        crosses_seam(domain_.curves[edge.curve].curve, edge.parameters))
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
std::vector<CurveEdge> PieceCutter::old_edges_of(const CurvePiece& piece) const {
  if (!options_.over_old_segments) return {};
  const double slack = 1e-9 * (piece.t1 - piece.t0);
  std::vector<CurveEdge> edges;
  double reached = piece.t0;
  for (const CurveEdge& edge : old_edges_[piece.curve]) {
    if (edge.parameters[1] <= piece.t0 + slack || edge.parameters[0] >= piece.t1 - slack) continue;
    if (std::fabs(edge.parameters[0] - reached) > slack) return {};
    reached = edge.parameters[1];
    edges.push_back(edge);
  }
  if (std::fabs(reached - piece.t1) > slack) return {};
  return edges;
}

CurveProfile PieceCutter::profile_of(const CurvePiece& piece, Index& hint) const {
  const std::vector<CurveEdge> old_edges = old_edges_of(piece);
  if (!old_edges.empty()) return measure_old_segments(background_, old_mesh_, old_edges, hint);
  return sample_curve(background_, curve_of(piece), piece.t0, piece.t1, options_.sample_length,
                      max_length_, hint);
}

bool PieceCutter::is_by_chords(const CurvePiece& piece) const {
  return !options_.over_old_segments && !is_straight(curve_of(piece));
}

/// A closed curve needs three edges, round quadrilaterals four; an embedded curve in the middle of
/// them two.
Index PieceCutter::least_count(const CurvePiece& piece) const {
  if (piece.start == piece.end) return options_.even ? 4 : 3;
  const CurveSides& sides = frame_.sides[piece.curve];
  const bool is_free = sides.left == sides.right && pieces_of_vertex_[piece.start] == 1 &&
                       pieces_of_vertex_[piece.end] == 1;
  return options_.even && is_free ? 2 : 1;
}

std::vector<double> PieceCutter::cut(const CurvePiece& piece, Index& hint) const {
  const CurveProfile profile = profile_of(piece, hint);
  const Index least = least_count(piece);
  if (!is_by_chords(piece))
    return equal_parts(profile, std::max(segment_count(profile.total()), least));
  return equal_chords(background_, curve_of(piece), profile, least, hint);
}

std::vector<double> PieceCutter::cut_into(const CurvePiece& piece, Index count, Index& hint) const {
  const CurveProfile profile = profile_of(piece, hint);
  if (!is_by_chords(piece)) return equal_parts(profile, count);
  return equal_chords_of_count(background_, curve_of(piece), profile, count, hint);
}

PieceCutter::Change PieceCutter::cheapest_change(const CurvePiece& piece,
                                                 const std::vector<double>& now,
                                                 Index& hint) const {
  const double length = is_by_chords(piece)
                            ? total_chord_length(background_, curve_of(piece), now, hint)
                            : profile_of(piece, hint).total();
  const Index count = static_cast<Index>(now.size()) - 1;
  const auto cost = [&](Index n) { return std::fabs(std::log(n / length)); };
  const bool fewer = count > least_count(piece) && cost(count - 1) < cost(count + 1);
  const Index changed = fewer ? count - 1 : count + 1;
  return {changed, cost(changed)};
}

}  // namespace anisofront
