#include "mesher/background/alternating_digital_tree.hpp"

namespace anisofront {

void AlternatingDigitalTree::insert(const Box& box) {
  const auto item = static_cast<Index>(nodes_.size());
  nodes_.push_back({box, {kNoIndex, kNoIndex}});
  if (item == 0) return;
  const std::array<double, 4> key{box.low.x, box.low.y, box.high.x, box.high.y};
  Region region = whole_region();
  Index node = 0;
  for (int axis = 0;; axis = (axis + 1) % 4) {
    const double middle = 0.5 * (region.low[axis] + region.high[axis]);
    const int side = key[axis] > middle ? 1 : 0;
    halve(region, axis, side);
    Index& child = nodes_[node].child[side];
    if (child == kNoIndex) {
      child = item;
      return;
    }
    node = child;
  }
}

}  // namespace anisofront
