#include "mesher/front/boundary_parts.hpp"

#include <algorithm>
#include <numeric>

#include "mesher/front/boundary_validity.hpp"
#include "mesher/geometry/predicates.hpp"

namespace anisofront {
namespace {

/// A closed walk along segments with one connected part of one region on its left.
struct Walk {
  std::vector<Index> sides;  ///< 2 s: along segment s, 2 s + 1: against it
  Index region = kNoIndex;
  Index component = kNoIndex;  ///< of the segments, joined at their ends
  double twice_area = 0;       ///< positive round a part, not positive round a hole in one
};

Index root_of(std::vector<Index>& parent, Index v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

class Walker {
 public:
  explicit Walker(const WorkMesh& mesh) : mesh_(mesh) {}

  BoundaryParts run() {
    sort_leaving();
    join_components();
    find_walks();
    BoundaryParts parts;
    parts.of_segment.assign(mesh_.segments.size(), {kNoIndex, kNoIndex});
    for (std::size_t w = 0; w < walks_.size(); ++w)
      if (walks_[w].twice_area > 0) paint(parts, walks_[w], parts.count++);
    for (const Walk& walk : walks_) {
      if (walk.twice_area > 0) continue;
      const Index part = part_round(parts, walk);
      paint(parts, walk, part == kNoIndex ? parts.count++ : part);
    }
    return parts;
  }

 private:
  Index side_count() const { return static_cast<Index>(2 * mesh_.segments.size()); }
  Index start_of(Index side) const {
    const Segment& s = mesh_.segments[side / 2];
    return side % 2 == 0 ? s.a : s.b;
  }
  Index end_of(Index side) const { return start_of(side ^ 1); }
  Point place_of(Index vertex) const { return mesh_.vertices[vertex].p; }

  Index region_of(Index side) const {
    const Segment& s = mesh_.segments[side / 2];
    return side % 2 == 0 ? s.left_region : s.right_region;
  }

  /// Whether one side leaves its vertex at a smaller angle, from the x axis on, than another.
  bool leaves_before(Index side, Index other) const {
    const Point o = place_of(start_of(side)), p = place_of(end_of(side)),
                q = place_of(end_of(other));
    const auto lower_half = [&](Point x) { return x.y < o.y || (x.y == o.y && x.x < o.x); };
    if (lower_half(p) != lower_half(q)) return lower_half(q);
    return orientation(o, p, q) > 0;
  }

  /// Sides by the vertex they leave, anticlockwise.
  void sort_leaving() {
    leaving_.resize(side_count());
    std::iota(leaving_.begin(), leaving_.end(), Index{0});
    std::sort(leaving_.begin(), leaving_.end(), [this](Index x, Index y) {
      const Index v = start_of(x), w = start_of(y);
      return v < w || (v == w && leaves_before(x, y));
    });
    place_in_order_.resize(leaving_.size());
    first_leaving_.assign(mesh_.vertices.size() + 1, 0);
    for (std::size_t i = 0; i < leaving_.size(); ++i) {
      place_in_order_[leaving_[i]] = static_cast<Index>(i);
      ++first_leaving_[start_of(leaving_[i]) + 1];
    }
    std::partial_sum(first_leaving_.begin(), first_leaving_.end(), first_leaving_.begin());
  }

  /// The side that goes on along the part on the left: the next clockwise from the way back.
  Index next_side(Index side) const {
    const Index v = end_of(side), back = place_in_order_[side ^ 1];
    return leaving_[(back == first_leaving_[v] ? first_leaving_[v + 1] : back) - 1];
  }

  void join_components() {
    component_.resize(mesh_.vertices.size());
    std::iota(component_.begin(), component_.end(), Index{0});
    for (const Segment& s : mesh_.segments)
      component_[root_of(component_, s.a)] = root_of(component_, s.b);
  }

  void find_walks() {
    std::vector<char> seen(side_count(), 0);
    for (Index first = 0; first < side_count(); ++first) {
      if (seen[first] || region_of(first) == kNoIndex) continue;
      Walk walk;
      walk.region = region_of(first);
      walk.component = root_of(component_, start_of(first));
      const Point origin = place_of(start_of(first));
      for (Index side = first; !seen[side]; side = next_side(side)) {
        seen[side] = 1;
        walk.sides.push_back(side);
        walk.twice_area += twice_area(origin, place_of(start_of(side)), place_of(end_of(side)));
      }
      walks_.push_back(std::move(walk));
    }
  }

  void paint(BoundaryParts& parts, const Walk& walk, Index part) const {
    for (const Index side : walk.sides) parts.of_segment[side / 2][side % 2] = part;
  }

  bool encloses(const Walk& outer, Point p) const {
    std::vector<Index> segments;
    for (const Index side : outer.sides) segments.push_back(side / 2);
    return is_inside(mesh_, segments, p);
  }

  /// The part in which a hole, or a curve that encloses nothing, lies; kNoIndex where rounding
  /// hides a part of nearly no area.
  Index part_round(const BoundaryParts& parts, const Walk& hole) const {
    std::vector<const Walk*> candidates;
    for (const Walk& walk : walks_)
      if (walk.twice_area > 0 && walk.region == hole.region && walk.component != hole.component)
        candidates.push_back(&walk);
    const auto smaller = [](const Walk* x, const Walk* y) { return x->twice_area < y->twice_area; };
    std::stable_sort(candidates.begin(), candidates.end(), smaller);
    const Walk* found = nullptr;
    for (const Walk* walk : candidates) {
      found = walk;
      if (candidates.size() == 1 || encloses(*walk, place_of(start_of(hole.sides[0])))) break;
    }
    if (!found) return kNoIndex;
    const Index side = found->sides[0];
    return parts.of_segment[side / 2][side % 2];
  }

  const WorkMesh& mesh_;
  std::vector<Index> leaving_;         ///< sides, sorted
  std::vector<Index> place_in_order_;  ///< per side: where it is in leaving_
  std::vector<Index> first_leaving_;   ///< per vertex: where its sides begin in leaving_
  std::vector<Index> component_;
  std::vector<Walk> walks_;
};

}  // namespace

BoundaryParts find_parts(const WorkMesh& mesh) { return Walker(mesh).run(); }

std::vector<Index> odd_parts(const BoundaryParts& parts) {
  std::vector<char> odd(parts.count, 0);
  for (const auto& sides : parts.of_segment)
    for (const Index part : sides)
      if (part != kNoIndex) odd[part] ^= 1;
  std::vector<Index> list;
  for (Index part = 0; part < parts.count; ++part)
    if (odd[part]) list.push_back(part);
  return list;
}

}  // namespace anisofront
