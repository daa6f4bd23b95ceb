#pragma once

#include <array>
#include <vector>

#include "solver/space/fe_mesh.hpp"

namespace anisofront {

/// The patches that stresses are fitted on. A vertex has one for each fan of elements around it
/// that hang together across edges where the stresses are continuous: one in the inside of a
/// region, one per region where regions meet.
struct FluxPatches {
  std::vector<std::array<Index, 4>> at_corner;  ///< patch of each corner of each element
  std::vector<Index> vertex;                    ///< of each patch
  std::vector<char> is_interior;                ///< the fan closes around the vertex
  /// Elements of patch p: elements[first[p]] .. elements[first[p + 1] - 1], ascending.
  std::vector<Index> first, elements;

  Index count() const { return static_cast<Index>(vertex.size()); }
};

/// Patches do not cross edges between regions, nor those marked in `jumps` (one char per edge of
/// the mesh, not 0 where stresses jump; empty: none). Numbered in the order of the elements'
/// corners. O(n).
FluxPatches flux_patches(const FeMesh& mesh, const std::vector<char>& jumps);

/// Elements of patches that share an element with patch p, and of these patches in turn, `rings`
/// times (0: the elements of p); ascending.
std::vector<Index> grown_patch(const FluxPatches& patches, Index p, int rings);

}  // namespace anisofront
