#include "solver/scalar/solve_scalar.hpp"

#include <chrono>
#include <string>

#include "mesher/geometry/error.hpp"
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

struct ImposedSystem {
  LinearSystem system;
  std::vector<Constraint> held;  ///< what is prescribed, and 0 where no element is
};

/// Columns without entries belong to vertices without elements.
void hold_unused(ImposedSystem& imposed) {
  SparseMatrix& matrix = imposed.system.matrix;
  const Index* outer = matrix.outerIndexPtr();
  const std::size_t first = imposed.held.size();
  for (Index v = 0; v < matrix.cols(); ++v)
    if (outer[v] == outer[v + 1]) imposed.held.push_back({v, 0});
  for (std::size_t k = first; k < imposed.held.size(); ++k)
    matrix.coeffRef(imposed.held[k].unknown, imposed.held[k].unknown) = 1;
  matrix.makeCompressed();
}

ImposedSystem imposed_system(const FeMesh& mesh, const ScalarProblem& problem, const DofMap& dofs,
                             const ScalarOptions& options, const Monitor& monitor) {
  check_conditions(mesh.mesh, problem);
  ImposedSystem imposed{{}, scalar_constraints(mesh, problem, dofs, monitor)};
  require_held_parts(mesh, problem, imposed.held);
  imposed.system = scalar_system(mesh, problem, dofs, options.order, options.threads);
  impose(imposed.held, imposed.system);
  hold_unused(imposed);
  return imposed;
}

/// The unknowns of the guess, with the values that are known already.
Eigen::VectorXd initial_values(const ScalarField& guess, const ScalarOptions& options,
                               const ImposedSystem& imposed) {
  if (guess.order != options.order || std::ssize(guess.values) != imposed.system.rhs.size())
    throw InputError("the initial guess is of order " + std::to_string(guess.order) + " with " +
                     std::to_string(guess.values.size()) + " values, expected order " +
                     std::to_string(options.order) + " with " +
                     std::to_string(imposed.system.rhs.size()) +
                     "; carry the field over to the mesh that is solved");
  Eigen::VectorXd values = Eigen::VectorXd::Map(guess.values.data(), std::ssize(guess.values));
  for (const auto& [unknown, value] : imposed.held) values[unknown] = value;
  return values;
}

LinearResult solve_imposed(const ImposedSystem& imposed, const ScalarProblem& problem,
                           const ScalarOptions& options, const Monitor& monitor) {
  LinearOptions linear = options.linear;
  linear.symmetric = !problem.has_convection();
  linear.scalar = true;
  if (!options.guess) return solve_linear(imposed.system, linear, monitor);
  const Eigen::VectorXd guess = initial_values(*options.guess, options, imposed);
  return solve_linear(imposed.system, linear, monitor, &guess);
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
  const ImposedSystem imposed = imposed_system(mesh, problem, field.dofs, options, monitor);
  solution.assembly_seconds = wall_seconds() - start;
  LinearResult result = solve_imposed(imposed, problem, options, monitor);
  solution.linear = std::move(result.report);
  field.values.assign(result.solution.begin(), result.solution.end());
  field.inner = inner_values(mesh, field.dofs, scalar_kernel(problem, options.order),
                             result.solution, options.threads);
  solution.squared_energy = squared_energy(mesh, problem, field, options.threads);
  return solution;
}

}  // namespace anisofront
