#pragma once

#include <string>
#include <vector>

#include "solver/plate/plate_reactions.hpp"
#include "solver/system/linear_solve.hpp"

namespace anisofront {

struct PlateOptions {
  PlateElement element = PlateElement::mitc;
  int threads = 0;  ///< 0: all cores
  LinearOptions linear;
};

struct PlateSolution {
  PlateElement element = PlateElement::mitc;
  DofMap dofs;
  std::vector<double> values;  ///< global unknowns, rotations in x and y
  std::vector<double> inner;   ///< two rotations per element (none with mitc4)
  PlateEnergy energy;
  /// 1/2 of the work of all loads and, in prescribed deflections, of the supports; equals
  /// energy.total() to round-off.
  double work = 0;
  double load = 0;     ///< resultant of all loads on w
  Vector load_moment;  ///< of all loads about the origin: sum of x F and of couples on theta
  std::vector<PlateReaction> reactions;
  double assembly_seconds = 0;
  LinearReport linear;
};

/// Throws InputError (see validate(); supports that leave a rigid motion free, naming the motion
/// and the part of the plate; supports that contradict each other at a vertex), UsageError (an
/// element that the mesh's shapes do not allow), MeshingError and BudgetError (see
/// solve_linear()). Warns of point loads and loaded point supports (w is unbounded below them) and
/// of hard supports and clamped edges on polygons in place of curves (Babuska's paradox).
PlateSolution solve_plate(const FeMesh& mesh, const PlateProblem& problem,
                          const PlateOptions& options = {}, const Monitor& monitor = {});

/// The state at a reference point of an element. In plate_states.cpp, as the next.
PlateState plate_state(const FeMesh& mesh, const PlateProblem& problem,
                       const PlateSolution& solution, const Element& element, ReferencePoint at);

/// The states at all vertices, averaged over the elements around each (of one region; where
/// regions of different material meet, over all).
std::vector<PlateState> vertex_states(const FeMesh& mesh, const PlateProblem& problem,
                                      const PlateSolution& solution);

}  // namespace anisofront
