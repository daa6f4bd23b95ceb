#include "mesher/front/curve_frame.hpp"

#include <algorithm>

#include "mesher/background/alternating_digital_tree.hpp"

namespace anisofront {
namespace {

class Framer {
 public:
  Framer(const Domain& domain, double tolerance, double corner_angle, const Monitor& monitor)
      : domain_(domain),
        monitor_(monitor),
        tolerance_(tolerance),
        on_curve_(1e3 * tolerance),
        corner_angle_(corner_angle) {}

  CurveFrame run() {
    find_sides();
    place_curve_ends();
    attach_points();
    split_at_kinks();
    add_pieces();
    return std::move(frame_);
  }

 private:
  struct Split {
    double parameter;
    Index vertex;
  };

  Index add_vertex(Point p) {
    frame_.vertices.push_back(p);
    return static_cast<Index>(frame_.vertices.size()) - 1;
  }

  void find_sides() {
    frame_.sides.resize(domain_.curves.size());
    for (std::size_t r = 0; r < domain_.regions.size(); ++r) {
      const auto region = static_cast<Index>(r);
      for (const Loop& loop : domain_.regions[r].loops)
        for (const CurveUse& use : loop)
          (use.reversed ? frame_.sides[use.curve].right : frame_.sides[use.curve].left) = region;
      for (const Index c : domain_.regions[r].embedded_curves) frame_.sides[c] = {region, region};
    }
    for (std::size_t c = 0; c < frame_.sides.size(); ++c)
      if (!frame_.sides[c].used())
        monitor_.warning("curve \"" + domain_.curves[c].name +
                         "\" bounds no region; it is left out");
  }

  /// Curves that end within the tolerance of each other share the vertex.
  void place_curve_ends() {
    struct End {
      Point p;
      Index curve;
      int side;
    };
    std::vector<End> ends;
    for (std::size_t c = 0; c < frame_.sides.size(); ++c) {
      if (!frame_.sides[c].used()) continue;
      const NurbsCurve& n = domain_.curves[c].curve;
      ends.push_back({n.points.front(), static_cast<Index>(c), 0});
      ends.push_back({n.points.back(), static_cast<Index>(c), 1});
    }
    ends_.assign(frame_.sides.size(), {kNoIndex, kNoIndex});
    // Sorted by x, ends that coincide lie close together; the first by curve number gives the
    // place.
    std::sort(ends.begin(), ends.end(), [](const End& e, const End& f) {
      return e.p.x < f.p.x ||
             (e.p.x == f.p.x && (e.curve < f.curve || (e.curve == f.curve && e.side < f.side)));
    });
    for (std::size_t i = 0; i < ends.size(); ++i) {
      Index vertex = kNoIndex;
      for (std::size_t j = i; j-- > 0 && ends[i].p.x - ends[j].p.x <= tolerance_;)
        if (norm(ends[i].p - ends[j].p) <= tolerance_) vertex = ends_[ends[j].curve][ends[j].side];
      if (vertex == kNoIndex) {
        vertex = add_vertex(ends[i].p);
        end_vertices_.push_back(vertex);
      }
      ends_[ends[i].curve][ends[i].side] = vertex;
    }
  }

  /// Domain points and ends of embedded curves that lie inside a curve split it there.
  void attach_points() {
    splits_.resize(frame_.sides.size());
    for (const DomainCurve& c : domain_.curves) boxes_.push_back(control_box(c.curve));
    for (const DomainPoint& point : domain_.points) {
      const Index end = curve_end_at(point.point);
      frame_.point_vertices.push_back(end != kNoIndex ? end : attach(point.point, kNoIndex));
    }
    for (const DomainRegion& region : domain_.regions)
      for (const Index c : region.embedded_curves)
        for (const Index v : ends_[c]) attach(frame_.vertices[v], v);
  }

  /// A curve lies in the convex hull of its control points.
  Box control_box(const NurbsCurve& c) const {
    Box box{c.points.front(), c.points.front()};
    for (const Point q : c.points) box = enclosing(box, q);
    const Vector margin{on_curve_, on_curve_};
    return {box.low - margin, box.high + margin};
  }

  Index curve_end_at(Point p) const {
    const auto at = std::lower_bound(end_vertices_.begin(), end_vertices_.end(), p.x - on_curve_,
                                     [&](Index v, double x) { return frame_.vertices[v].x < x; });
    for (auto v = at; v != end_vertices_.end(); ++v) {
      const Point q = frame_.vertices[*v];
      if (q.x > p.x + on_curve_) break;
      if (norm(q - p) <= on_curve_) return *v;
    }
    return kNoIndex;
  }

  /// Splits the curves that pass through p, but do not end there, at a common vertex: `vertex` or a
  /// new one. Returns it, or kNoIndex when p lies on no curve.
  Index attach(Point p, Index vertex) {
    for (std::size_t c = 0; c < frame_.sides.size(); ++c) {
      if (!frame_.sides[c].used() || !overlap(boxes_[c], {p, p})) continue;
      if (vertex != kNoIndex && (vertex == ends_[c][0] || vertex == ends_[c][1])) continue;
      const NearestPoint nearest = nearest_point(domain_.curves[c].curve, p);
      if (nearest.distance > on_curve_) continue;
      // The same place may come several times: points there, curves that end there.
      bool known = false;
      for (const Split& split : splits_[c]) {
        if (norm(frame_.vertices[split.vertex] - p) > on_curve_) continue;
        vertex = split.vertex;
        known = true;
      }
      if (vertex == kNoIndex)
        vertex = add_vertex(nearest.distance > tolerance_ ? nearest.point : p);
      if (!known) splits_[c].push_back({nearest.parameter, vertex});
    }
    return vertex;
  }

  /// Cut off by no edge, the corners of a polyline stay.
  void split_at_kinks() {
    for (std::size_t c = 0; c < frame_.sides.size(); ++c) {
      if (!frame_.sides[c].used()) continue;
      for (const CurveKink& kink : kinks(domain_.curves[c].curve, corner_angle_)) {
        const auto is_there = [&](const Split& split) {
          return norm(frame_.vertices[split.vertex] - kink.point) <= on_curve_;
        };
        if (std::none_of(splits_[c].begin(), splits_[c].end(), is_there))
          splits_[c].push_back({kink.parameter, add_vertex(kink.point)});
      }
    }
  }

  void add_pieces() {
    for (std::size_t c = 0; c < frame_.sides.size(); ++c) {
      if (!frame_.sides[c].used()) continue;
      const auto id = static_cast<Index>(c);
      std::sort(splits_[c].begin(), splits_[c].end(),
                [](const Split& x, const Split& y) { return x.parameter < y.parameter; });
      CurvePiece piece{id, domain_.curves[c].curve.begin_parameter(), 0, ends_[c][0], kNoIndex};
      for (const Split& split : splits_[c]) {
        piece.t1 = split.parameter;
        piece.end = split.vertex;
        frame_.pieces.push_back(piece);
        piece.t0 = split.parameter;
        piece.start = split.vertex;
      }
      piece.t1 = domain_.curves[c].curve.end_parameter();
      piece.end = ends_[c][1];
      frame_.pieces.push_back(piece);
    }
  }

  const Domain& domain_;
  const Monitor& monitor_;
  double tolerance_;  ///< ends of curves nearer than this are one point
  double on_curve_;   ///< points nearer than this to a curve lie on it
  double corner_angle_;
  CurveFrame frame_;
  std::vector<std::array<Index, 2>> ends_;  ///< per curve: vertices of its two ends
  std::vector<Index> end_vertices_;         ///< by ascending x
  std::vector<Box> boxes_;                  ///< per curve
  std::vector<std::vector<Split>> splits_;
};

}  // namespace

CurveFrame make_curve_frame(const Domain& domain, double tolerance, double corner_angle,
                            const Monitor& monitor) {
  return Framer(domain, tolerance, corner_angle, monitor).run();
}

}  // namespace anisofront
