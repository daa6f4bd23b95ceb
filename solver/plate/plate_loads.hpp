#pragma once

#include "solver/plate/plate_elements.hpp"

namespace anisofront {

/// Adds edge loads and point loads to the right-hand side (in x and y components):
/// int Q_n v - M_n eta_n - M_ns eta_s along the edges, n to the right of the edge's direction
/// (outward on an outer boundary), exact for linear loads on straight edges. Arnold-Falk takes
/// the deflection of an edge as constant along it. Throws InputError for values that are not
/// finite, with the place, and for point loads outside the mesh; UsageError for point loads on
/// elements without a deflection at vertices.
void add_edge_loads(const FeMesh& mesh, const DofMap& dofs, PlateElement element,
                    const PlateProblem& problem, Eigen::VectorXd& rhs);
void add_point_loads(const FeMesh& mesh, const DofMap& dofs, PlateElement element,
                     const PlateProblem& problem, Eigen::VectorXd& rhs);

/// Resultant of the loads: the work that they do in w = 1, and in (w, theta) = (x, e_x), (y, e_y).
struct LoadResultant {
  double force = 0;
  Vector moment;        ///< about the origin: sum of x F and of the couples on theta
  double absolute = 0;  ///< sum of the amounts of the forces on the single unknowns
};
LoadResultant resultant(const FeMesh& mesh, const DofMap& dofs, PlateElement element,
                        const Eigen::VectorXd& rhs);

}  // namespace anisofront
