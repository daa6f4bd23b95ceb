#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "mesher/geometry/point.hpp"

namespace anisofront {

/// An axis-parallel box, closed.
struct Box {
  Point low, high;
};

/// The box grown to hold p.
inline Box enclosing(const Box& box, Point p) {
  return {{std::min(box.low.x, p.x), std::min(box.low.y, p.y)},
          {std::max(box.high.x, p.x), std::max(box.high.y, p.y)}};
}

inline bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && a.high.x >= b.low.x && a.low.y <= b.high.y && a.high.y >= b.low.y;
}

/// Alternating digital tree over boxes: a box is a point (x0, y0, x1, y1) of a four-dimensional
/// space whose regions are halved along the coordinates in turn; every tree node holds one box.
/// Finds all boxes that overlap a query box in O(log n + hits) on average.
/// Reference (24 of the paper): J. Bonet, J. Peraire, An alternating digital tree (ADT) algorithm
/// for 3D geometric searching and intersection problems, Int. J. Numer. Methods Eng. 31 (1991),
/// doi:10.1002/nme.1620310102.
class AlternatingDigitalTree {
 public:
  /// `bounds` encloses every box that will be inserted.
  explicit AlternatingDigitalTree(const Box& bounds) : bounds_(bounds) {}

  void reserve(std::size_t count) { nodes_.reserve(count); }

  /// Inserts the next box; its item number is the number of boxes inserted before.
  void insert(const Box& box);

  /// Calls visit(item) for every box that overlaps `query`, in tree order.
  template <class Visit>
  void query(const Box& query, Visit&& visit) const {
    if (!nodes_.empty()) descend(0, 0, whole_region(), query, visit);
  }

 private:
  struct Node {
    Box box;
    std::array<Index, 2> child{kNoIndex, kNoIndex};
  };
  /// A region of the four-dimensional space: bounds of x0, y0, x1, y1.
  struct Region {
    std::array<double, 4> low, high;
  };
  Region whole_region() const {
    return {{bounds_.low.x, bounds_.low.y, bounds_.low.x, bounds_.low.y},
            {bounds_.high.x, bounds_.high.y, bounds_.high.x, bounds_.high.y}};
  }
  static void halve(Region& region, int axis, int side) {
    const double middle = 0.5 * (region.low[axis] + region.high[axis]);
    (side == 0 ? region.high : region.low)[axis] = middle;
  }
  /// Whether boxes with corners in `region` can overlap the query.
  static bool may_overlap(const Region& region, const Box& query) {
    return region.low[0] <= query.high.x && region.low[1] <= query.high.y &&
           region.high[2] >= query.low.x && region.high[3] >= query.low.y;
  }

  template <class Visit>
  void descend(Index item, int axis, const Region& region, const Box& query, Visit& visit) const {
    const Node& node = nodes_[item];
    if (overlap(node.box, query)) visit(item);
    for (int side = 0; side < 2; ++side) {
      if (node.child[side] == kNoIndex) continue;
      Region half = region;
      halve(half, axis, side);
      if (may_overlap(half, query)) descend(node.child[side], (axis + 1) % 4, half, query, visit);
    }
  }

  Box bounds_;
  std::vector<Node> nodes_;
};

}  // namespace anisofront
