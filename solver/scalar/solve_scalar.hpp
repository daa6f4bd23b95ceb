#pragma once

#include "mesher/geometry/monitor.hpp"
#include "solver/scalar/scalar_field.hpp"
#include "solver/scalar/scalar_problem.hpp"
#include "solver/system/linear_solve.hpp"

namespace anisofront {

struct ScalarOptions {
  int order = 1;
  int threads = 0;  ///< 0: all cores
  LinearOptions linear;
  /// Where multigrid starts (see LinearMethod), a field of this order on the mesh that is solved,
  /// such as the solution on an earlier mesh carried over; its inner values are not used. Direct
  /// methods ignore it. Null: none.
  const ScalarField* guess = nullptr;
};

struct ScalarSolution {
  ScalarField field;
  /// int a |grad u_h|^2 + c u_h^2 over the domain (Robin terms not counted).
  double squared_energy = 0;
  double assembly_seconds = 0;  ///< wall time
  LinearReport linear;
};

/// Vertices that no element has get the value 0.
/// Throws InputError: a <= 0, c < 0, values that are not finite (with the place), a condition whose
/// tag no edge carries, a tag with two conditions, a part of the mesh where u is free up to a
/// constant (named by its region), an element that is turned inside out or flat (with the place), a
/// guess of another order or size or with values that are not finite; MeshingError and BudgetError:
/// see solve_linear(). Precondition: order 1 or 2.
ScalarSolution solve_scalar(const FeMesh& mesh, const ScalarProblem& problem,
                            const ScalarOptions& options = {}, const Monitor& monitor = {});

/// int a |grad v|^2 + c v^2 of any field.
double squared_energy(const FeMesh& mesh, const ScalarProblem& problem, const ScalarField& field,
                      int threads = 0);

}  // namespace anisofront
