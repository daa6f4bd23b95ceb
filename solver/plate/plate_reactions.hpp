#pragma once

#include <vector>

#include "solver/plate/support_nodes.hpp"

namespace anisofront {

/// Forces and couples that the supports of one tag exert on the plate. A vertex where several
/// supported curves meet counts to each that holds it in equal parts; couples there are along the
/// directions that each holds.
struct PlateReaction {
  Index tag = 0;       ///< 0: point supports
  double force = 0;    ///< on w, positive along w
  Vector moment;       ///< conjugate to theta_x and theta_y
  Vector lever;        ///< sum of position x force: with `moment` the couple about the origin
  double largest = 0;  ///< amount of the largest force on a single node
};

/// The rows of the system at supported nodes, kept from before conditions are imposed: their
/// residual is what the supports exert.
struct SupportRows {
  std::vector<Index> unknowns;  ///< w, theta_x, theta_y of each node (kNoIndex: none)
  SparseMatrix rows;            ///< transposed: a column per entry of `unknowns`
  Eigen::VectorXd rhs;
};

/// Precondition: the system is symmetric, in x and y components, with all loads.
SupportRows support_rows(const LinearSystem& system, const std::vector<SupportNode>& nodes,
                         const DofMap& dofs, PlateElement element);

struct SupportForces {
  std::vector<PlateReaction> reactions;  ///< in the order of the supports, point supports last
  double work = 0;                       ///< of the forces in the prescribed deflections
};

/// `solution` in x and y components. Loads and reactions balance to round-off.
SupportForces support_forces(const SupportRows& rows, const std::vector<SupportNode>& nodes,
                             const PlateProblem& problem, const Eigen::VectorXd& solution);

}  // namespace anisofront
