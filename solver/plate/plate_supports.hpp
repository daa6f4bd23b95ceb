#pragma once

#include <vector>

#include "solver/plate/support_nodes.hpp"
#include "solver/system/constraints.hpp"

namespace anisofront {

/// The essential conditions of a plate on its unknowns: frames turn rotations to (n, s) where that
/// is needed, constraints hold in frame components.
struct PlateConditions {
  std::vector<Frame> frames;
  std::vector<Constraint> constraints;
};

/// Normals are those of the curve; where it is not known, at a vertex between edges of one tag that
/// turn by less than 30 degrees and is no corner of the mesh, the mean normal; elsewhere the union
/// of both. Throws InputError for contradictions (two deflections at one vertex), with the place.
PlateConditions plate_conditions(const FeMesh& mesh, const DofMap& dofs, PlateElement element,
                                 const PlateProblem& problem);

/// The same from what is held at the nodes.
PlateConditions plate_conditions(const std::vector<SupportNode>& nodes, const DofMap& dofs,
                                 PlateElement element);

/// Throws InputError unless the conditions hold every connected part of the plate: the three rigid
/// motions w = 1, (w, theta) = (x, e_x), (y, e_y) restricted to the constrained unknowns must be
/// independent. The message names the motion that is free ("can move as a rigid body: no curve
/// supports w", "can turn about the line through ...") and the region. In plate_mechanism.cpp.
void require_supported(const FeMesh& mesh, const DofMap& dofs, PlateElement element,
                       const PlateConditions& conditions);

}  // namespace anisofront
