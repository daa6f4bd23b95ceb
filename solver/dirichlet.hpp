#pragma once

#include <span>
#include <vector>

#include "mesher/mesh/mesh.hpp"
#include "solver/assemble.hpp"
#include "solver/scalar_problem.hpp"

namespace anisofront {

/// A prescribed unknown.
struct Constraint {
  Index unknown = kNoIndex;
  double value = 0;
};

/// The vertices on edges with a Dirichlet condition, in ascending order.
/// Throws InputError for a condition whose tag no edge carries (with the group name) and for a
/// value that is not finite (with the point).
std::vector<Constraint> dirichlet_constraints(const Mesh& mesh,
                                              std::span<const DirichletCondition> conditions);

/// Imposes the constraints and keeps the system symmetric: rows and columns become zero but for the
/// diagonal, which keeps its size so that the conditioning stays as it is.
void impose(std::span<const Constraint> constraints, LinearSystem& system);

}  // namespace anisofront
