#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesher/background/alternating_digital_tree.hpp"
#include "mesher/front/front_edge.hpp"

namespace anisofront {

/// Finds the front edges near a place. Level L divides the square around the domain into 4^L cells;
/// an edge sits in the one cell that holds its midpoint, on the level whose cell size is next above
/// its extent, so it sticks out of the cell by at most half a cell ("loose"). Levels up to `depth`
/// are dense arrays, deeper ones are quadtrees below the cells of the last dense level. The edges
/// of a cell form a list through the edges themselves. Reference: T. Ulrich, Loose octrees, Game
/// Programming Gems 1 (2000); measured against uniform grids and the alternating digital tree,
/// which costs two to three times as much here.
class EdgeIndex {
 public:
  /// `typical_size`: expected edge extent; the dense levels end where cells reach it.
  EdgeIndex(const Box& bounds, double typical_size);

  void insert(std::vector<FrontEdge>& edges, Index id);
  void remove(std::vector<FrontEdge>& edges, Index id);

  /// Appends to `found` (cleared first) the edges whose bounding boxes overlap the box, except
  /// `skip`. The order depends on the history of insertions only.
  void query(const std::vector<FrontEdge>& edges, const Box& box, Index skip,
             std::vector<Index>& found) const;

 private:
  static constexpr int kMaxDense = 9;
  static constexpr int kMaxLevel = 28;

  struct Cell {
    Index children = kNoIndex;  ///< first of four consecutive cells
    Index parent = kNoIndex;
    Index head = kNoIndex;  ///< first edge of the list
    Index count = 0;        ///< edges here and below
  };
  struct Corner {
    double x, y;
  };

  int level_of(const FrontEdge& edge) const;
  Index dense_cell(int level, double x, double y) const;
  Index deep_cell(int level, double x, double y);
  Index new_children(Index parent);
  void uncount(Index cell);
  void scan(const std::vector<FrontEdge>& edges, Index cell, const Box& box, Index skip,
            std::vector<Index>& found) const;
  void descend(const std::vector<FrontEdge>& edges, Index children, Corner corner, double size,
               const Box& box, Index skip, std::vector<Index>& found) const;

  Point origin_;
  double extent_;
  int depth_;
  std::array<Index, kMaxDense + 2> level_start_{};
  std::array<std::int64_t, kMaxDense + 1> level_count_{};
  std::array<double, kMaxLevel + 1> cell_size_{};
  std::array<double, kMaxLevel + 1> inverse_size_{};
  std::vector<Cell> cells_;
  std::vector<Index> free_blocks_;
};

}  // namespace anisofront
