#include "solver/scalar/solve_scalar.hpp"

#include <chrono>

#include "solver/scalar/element_sum.hpp"
#include "solver/scalar/held_parts.hpp"
#include "solver/scalar/scalar_basis.hpp"
#include "solver/scalar/scalar_boundary.hpp"
#include "solver/scalar/scalar_kernel.hpp"
#include "solver/scalar/scalar_system.hpp"

namespace anisofront {
namespace {

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Columns without entries belong to vertices without elements.
void hold_unused(LinearSystem& system) {
  std::vector<Index> unused;
  const Index* outer = system.matrix.outerIndexPtr();
  for (Index v = 0; v < system.matrix.cols(); ++v)
    if (outer[v] == outer[v + 1]) unused.push_back(v);
  for (const Index v : unused) system.matrix.coeffRef(v, v) = 1;
  system.matrix.makeCompressed();
}

LinearSystem imposed_system(const FeMesh& mesh, const ScalarProblem& problem, const DofMap& dofs,
                            const ScalarOptions& options, const Monitor& monitor) {
  check_conditions(mesh.mesh, problem);
  const auto constraints = scalar_constraints(mesh, problem, dofs, monitor);
  require_held_parts(mesh, problem, constraints);
  LinearSystem system = scalar_system(mesh, problem, dofs, options.order, options.threads);
  impose(constraints, system);
  hold_unused(system);
  return system;
}

}  // namespace

double squared_energy(const FeMesh& mesh, const ScalarProblem& problem, const ScalarField& field,
                      int threads) {
  ScalarProblem form;
  form.diffusion = problem.diffusion;
  form.reaction = problem.reaction;
  const ElementKernel kernel = scalar_kernel(form, field.order);
  return element_sum<double>(mesh.element_count(), threads, [&](Index e) {
    const Element element = element_at(mesh, e);
    ElementSystem system;
    kernel(element, system);
    const LocalValues u = local_values(mesh, field.dofs, element, field.values, field.inner);
    return u.dot(system.matrix * u);
  });
}

ScalarSolution solve_scalar(const FeMesh& mesh, const ScalarProblem& problem,
                            const ScalarOptions& options, const Monitor& monitor) {
  ScalarSolution solution;
  ScalarField& field = solution.field;
  field.order = options.order;
  field.dofs = make_dof_map(mesh, scalar_layout(options.order));
  const double start = wall_seconds();
  const LinearSystem system = imposed_system(mesh, problem, field.dofs, options, monitor);
  solution.assembly_seconds = wall_seconds() - start;
  LinearOptions linear = options.linear;
  linear.symmetric = !problem.has_convection();
  linear.scalar = true;
  LinearResult result = solve_linear(system, linear, monitor);
  solution.linear = std::move(result.report);
  field.values.assign(result.solution.begin(), result.solution.end());
  field.inner = inner_values(mesh, field.dofs, scalar_kernel(problem, options.order),
                             result.solution, options.threads);
  solution.squared_energy = squared_energy(mesh, problem, field, options.threads);
  return solution;
}

}  // namespace anisofront
