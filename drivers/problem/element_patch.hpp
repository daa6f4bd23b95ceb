#pragma once

#include <array>
#include <vector>

#include "adapt/point_location.hpp"
#include "mesher/mesh/topology.hpp"

namespace anisofront {

/// Which elements share an edge or a vertex.
class ElementPatches {
 public:
  /// `mesh` must outlive it.
  explicit ElementPatches(const FeMesh& mesh);

  /// The place itself, and where it lies on an edge or a vertex of its element also in all others
  /// that share these, by ascending number.
  std::vector<Location> around(const Location& place) const;

  /// The corners of all elements at a vertex.
  std::vector<Location> around_vertex(Index vertex) const;

 private:
  std::vector<Location> around_edge(Index edge, Index from, double t) const;

  const FeMesh& mesh_;
  VertexStars stars_;
  std::vector<std::array<Index, 2>> edge_elements_;  ///< kNoIndex where there is none
};

}  // namespace anisofront
