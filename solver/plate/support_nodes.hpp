#pragma once

#include <vector>

#include "solver/plate/plate_elements.hpp"

namespace anisofront {

/// A deflection that the supports with this tag (0: point supports) prescribe.
struct HeldDeflection {
  Index tag = 0;
  double value = 0;
};

/// The rotations that the supports with this tag hold: unit directions, one or two (all).
struct HeldRotation {
  Index tag = 0;
  std::vector<Vector> directions;
};

/// What the supports hold at a vertex or an edge that carries unknowns.
struct SupportNode {
  Index number = kNoIndex;  ///< of the vertex or of the edge
  bool on_edge = false;
  Point at;
  std::vector<HeldDeflection> deflections;  ///< empty where w is free; all of one value
  std::vector<HeldRotation> rotations;      ///< by support
  std::vector<Vector> directions;           ///< held by any of them: none, one or two (all)
};

struct SupportNodes {
  std::vector<SupportNode> nodes;  ///< vertices, then edges, by number
  /// Per entry of PlateProblem::supports the vertices where chords of a curve that is not known
  /// meet at an angle, with the mean normal.
  std::vector<Index> smooth_joints;
};

/// See plate_conditions(). Throws InputError for contradictory deflections, with the place, and
/// UsageError for point supports of elements without a deflection at vertices.
SupportNodes support_nodes(const FeMesh& mesh, PlateElement element, const PlateProblem& problem);

/// First unknown of a node, and which of its unknowns are w and theta_x (-1: none).
struct NodeUnknowns {
  Index first = kNoIndex;
  PlateComponents components;

  Index deflection() const { return first + components.w; }
  Index rotation() const { return first + components.rotation; }
};
NodeUnknowns unknowns_of(const SupportNode& node, const DofMap& dofs, PlateElement element);

}  // namespace anisofront
