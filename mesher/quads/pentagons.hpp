#pragma once

#include <array>

#include "mesher/front/work_mesh.hpp"

namespace anisofront {

/// A face that is to be divided, with its edges: edges[k] runs from vertices[k] to the next one.
struct Cell {
  int size = 0;  ///< 3 to 5
  std::array<Index, 5> vertices{};
  std::array<Index, 5> edges{};
};

/// Triangle and quadrilateral without their common edge, which is edge i of the one and j of the
/// other: a pentagon that starts at the apex of the triangle, so that the edge joined vertices 1
/// and 4.
Cell join(const Cell& triangle, int i, const Cell& quad, int j);

/// Deviation from right angles at the three nodes of the triangle that a pentagon made by join()
/// holds, in the metric at each (Eqn 28), radians.
double angle_deviation(const std::array<WorkVertex, 5>& pentagon);

/// Whether one of these angles is above 165 degrees. It would be that of a quadrilateral for good
/// where both sides are on the boundary; divided apart, triangle and quadrilateral share it.
bool has_flat_corner(const std::array<WorkVertex, 5>& pentagon);

}  // namespace anisofront
