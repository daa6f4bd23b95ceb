#include "solver/solve_scalar.hpp"

#include "mesher/geometry/error.hpp"
#include "solver/assemble.hpp"
#include "solver/dirichlet.hpp"
#include "solver/linear_solve.hpp"

namespace anisofront {

std::vector<double> solve_scalar(const Mesh& mesh, const ScalarProblem& problem) {
  if (problem.dirichlet.empty() && problem.reaction == 0)
    throw InputError(
        "a problem without reaction needs a value on at least one curve: its solution"
        " is free up to a constant");
  LinearSystem system = assemble(mesh, problem);
  impose(dirichlet_constraints(mesh, problem.dirichlet), system);
  const Eigen::VectorXd u = solve_positive_definite(system);
  return {u.begin(), u.end()};
}

}  // namespace anisofront
