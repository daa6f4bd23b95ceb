#pragma once

#include "solver/scalar/scalar_field.hpp"
#include "solver/scalar/scalar_problem.hpp"

namespace anisofront {

/// int a du/dn over the edges with this tag, n outward, of the solution `field` of the problem.
/// Where u is prescribed it is the reaction, the residual of the discrete equations (converges
/// twice as fast as a du_h/dn; with the other curves it balances the sources exactly); at vertices
/// that two prescribed curves share, the residual is divided between them according to a du_h/dn on
/// their edges there. Where a flux is prescribed it is int flux - transfer u_h, else 0.
/// Throws InputError for a tag that no edge carries. Precondition: `field` is a solution on `mesh`.
double total_flux(const FeMesh& mesh, const ScalarProblem& problem, const ScalarField& field,
                  Index tag, int threads = 0);

}  // namespace anisofront
