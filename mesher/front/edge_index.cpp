#include "mesher/front/edge_index.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {

EdgeIndex::EdgeIndex(const Box& bounds, double typical_size)
    : origin_(bounds.low),
      extent_(1.0001 * std::max(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y)),
      depth_(std::clamp(std::ilogb(extent_ / typical_size), 0, kMaxDense)) {
  Index cells = 0;
  for (int level = 0; level <= depth_; ++level) {
    level_start_[level] = cells;
    cells += Index{1} << (2 * level);
  }
  level_start_[depth_ + 1] = cells;
  cells_.resize(cells);
  for (int level = 0; level <= kMaxLevel; ++level) {
    cell_size_[level] = std::ldexp(extent_, -level);
    inverse_size_[level] = 1 / cell_size_[level];
  }
}

int EdgeIndex::level_of(const FrontEdge& edge) const {
  const double size = std::max(std::fabs(edge.b.x - edge.a.x), std::fabs(edge.b.y - edge.a.y));
  return std::clamp(std::ilogb(extent_ / std::max(size, extent_ * 1e-9)), 0, kMaxLevel);
}

Index EdgeIndex::dense_cell(int level, double x, double y) const {
  const Index last = (Index{1} << level) - 1;
  const Index i = std::clamp(static_cast<Index>(x * inverse_size_[level]), Index{0}, last);
  const Index j = std::clamp(static_cast<Index>(y * inverse_size_[level]), Index{0}, last);
  return level_start_[level] + ((j << level) | i);
}

Index EdgeIndex::new_children(Index parent) {
  Index block;
  if (free_blocks_.empty()) {
    block = static_cast<Index>(cells_.size());
    cells_.resize(cells_.size() + 4);
  } else {
    block = free_blocks_.back();
    free_blocks_.pop_back();
  }
  for (Index k = 0; k < 4; ++k) cells_[block + k] = {kNoIndex, parent, kNoIndex, 0};
  cells_[parent].children = block;
  return block;
}

Index EdgeIndex::deep_cell(int level, double x, double y) {
  const Index last = (Index{1} << level) - 1;
  const Index i = std::clamp(static_cast<Index>(x * inverse_size_[level]), Index{0}, last);
  const Index j = std::clamp(static_cast<Index>(y * inverse_size_[level]), Index{0}, last);
  const int below = level - depth_;
  Index cell = level_start_[depth_] + (((j >> below) << depth_) | (i >> below));
  ++cells_[cell].count;
  for (int bit = below - 1; bit >= 0; --bit) {
    Index children = cells_[cell].children;
    if (children == kNoIndex) children = new_children(cell);
    cell = children + (((i >> bit) & 1) | (((j >> bit) & 1) << 1));
    ++cells_[cell].count;
  }
  return cell;
}

void EdgeIndex::insert(std::vector<FrontEdge>& edges, Index id) {
  FrontEdge& edge = edges[id];
  const int level = level_of(edge);
  const double x = 0.5 * (edge.a.x + edge.b.x) - origin_.x;
  const double y = 0.5 * (edge.a.y + edge.b.y) - origin_.y;
  Index cell;
  if (level <= depth_) {
    cell = dense_cell(level, x, y);
    ++cells_[cell].count;
  } else {
    cell = deep_cell(level, x, y);
  }
  ++level_count_[std::min(level, depth_)];
  edge.cell = cell;
  edge.cell_previous = kNoIndex;
  edge.cell_next = cells_[cell].head;
  if (edge.cell_next != kNoIndex) edges[edge.cell_next].cell_previous = id;
  cells_[cell].head = id;
}

void EdgeIndex::uncount(Index cell) {
  if (cell < level_start_[depth_]) {
    int level = 0;
    while (cell >= level_start_[level + 1]) ++level;
    --level_count_[level];
    --cells_[cell].count;
    return;
  }
  --level_count_[depth_];
  for (; cell != kNoIndex; cell = cells_[cell].parent) {
    if (--cells_[cell].count == 0 && cells_[cell].children != kNoIndex) {
      free_blocks_.push_back(cells_[cell].children);
      cells_[cell].children = kNoIndex;
    }
  }
}

void EdgeIndex::remove(std::vector<FrontEdge>& edges, Index id) {
  const FrontEdge& edge = edges[id];
  if (edge.cell_previous == kNoIndex)
    cells_[edge.cell].head = edge.cell_next;
  else
    edges[edge.cell_previous].cell_next = edge.cell_next;
  if (edge.cell_next != kNoIndex) edges[edge.cell_next].cell_previous = edge.cell_previous;
  uncount(edge.cell);
}

void EdgeIndex::scan(const std::vector<FrontEdge>& edges, Index cell, const Box& box, Index skip,
                     std::vector<Index>& found) const {
  for (Index id = cells_[cell].head; id != kNoIndex;) {
    const FrontEdge& e = edges[id];
    if (std::min(e.a.x, e.b.x) <= box.high.x && std::max(e.a.x, e.b.x) >= box.low.x &&
        std::min(e.a.y, e.b.y) <= box.high.y && std::max(e.a.y, e.b.y) >= box.low.y && id != skip)
      found.push_back(id);
    id = e.cell_next;
  }
}

void EdgeIndex::descend(const std::vector<FrontEdge>& edges, Index children, Corner corner,
                        double size, const Box& box, Index skip, std::vector<Index>& found) const {
  const double loose = 0.5 * size;
  for (Index k = 0; k < 4; ++k) {
    const Cell& cell = cells_[children + k];
    if (cell.count == 0) continue;
    const Corner c{corner.x + (k & 1 ? size : 0), corner.y + (k & 2 ? size : 0)};
    if (c.x - loose > box.high.x || c.x + size + loose < box.low.x || c.y - loose > box.high.y ||
        c.y + size + loose < box.low.y)
      continue;
    scan(edges, children + k, box, skip, found);
    if (cell.children != kNoIndex) descend(edges, cell.children, c, 0.5 * size, box, skip, found);
  }
}

void EdgeIndex::query(const std::vector<FrontEdge>& edges, const Box& box, Index skip,
                      std::vector<Index>& found) const {
  found.clear();
  for (int level = 0; level <= depth_; ++level) {
    if (level_count_[level] == 0) continue;
    const double loose = 0.5 * cell_size_[level];
    const double s = inverse_size_[level];
    const Index last = (Index{1} << level) - 1;
    // Clamp as doubles: boxes may reach far beyond what an Index holds.
    const auto cell_at = [last](double v) {
      return static_cast<Index>(std::clamp(v, 0., static_cast<double>(last)));
    };
    const Index i0 = cell_at((box.low.x - loose - origin_.x) * s);
    const Index i1 = cell_at((box.high.x + loose - origin_.x) * s);
    const Index j0 = cell_at((box.low.y - loose - origin_.y) * s);
    const Index j1 = cell_at((box.high.y + loose - origin_.y) * s);
    for (Index j = j0; j <= j1; ++j) {
      for (Index i = i0; i <= i1; ++i) {
        const Index id = level_start_[level] + ((j << level) | i);
        const Cell& cell = cells_[id];
        if (cell.count == 0) continue;
        scan(edges, id, box, skip, found);
        if (cell.children != kNoIndex)
          descend(edges, cell.children,
                  {origin_.x + i * cell_size_[level], origin_.y + j * cell_size_[level]},
                  0.5 * cell_size_[level], box, skip, found);
      }
    }
  }
}

}  // namespace anisofront
