#pragma once

#include <vector>

#include "mesher/front/front_edge.hpp"

namespace anisofront {

/// The apex of a possible element: an existing front vertex, or kNoIndex for a new one.
struct Apex {
  Index vertex = kNoIndex;
  Point p;
};

/// Whether the triangle of the base segment and the apex lies in the part still to be meshed.
/// `near` holds every front edge (the base apart) whose box meets that of the triangle.
///
/// Exact and free of topology: the triangle must be anticlockwise, no end point of a front edge
/// other than its own vertices may lie in the closed triangle, and no front edge may cross its two
/// new sides. Then the rest of the domain stays a valid polygon, in which each edge sees some
/// vertex: the front can always be closed.
///
/// Edges that block are moved forward in `near`, because they tend to block again.
bool is_valid_element(const FrontEdge& base, const Apex& apex, const std::vector<FrontEdge>& edges,
                      std::vector<Index>& near);

}  // namespace anisofront
