#include "solver/scalar/scalar_system.hpp"

#include "solver/scalar/scalar_boundary.hpp"
#include "solver/scalar/scalar_kernel.hpp"

namespace anisofront {

LinearSystem scalar_system(const FeMesh& mesh, const ScalarProblem& problem, const DofMap& dofs,
                           int order, int threads) {
  LinearSystem system = assemble(mesh, dofs, scalar_kernel(problem, order), threads);
  add_fluxes(mesh, problem, dofs, system);
  return system;
}

}  // namespace anisofront
