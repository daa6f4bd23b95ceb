#include <cmath>
#include <memory>

#include "adapt/energy_estimate.hpp"
#include "adapt/model.hpp"
#include "adapt/transfer.hpp"
#include "mesher/geometry/stopwatch.hpp"
#include "solver/scalar/norms.hpp"

namespace anisofront {
namespace {

std::vector<double> vertex_values(const FeMesh& mesh, const ScalarField& field) {
  return {field.values.begin(),
          field.values.begin() + static_cast<std::ptrdiff_t>(mesh.mesh.points.size())};
}

std::vector<double> nodal_error(const Mesh& mesh, const ExactSolution& exact,
                                const std::vector<double>& u) {
  std::vector<double> error;
  for (std::size_t v = 0; v < u.size(); ++v) error.push_back(exact.value(mesh.points[v]) - u[v]);
  return error;
}

void add_truth(const FeMesh& mesh, const ScalarProblem& problem, const ExactSolution& exact,
               const ScalarField& field, SolvedModel& solved) {
  Stopwatch watch;
  const ErrorNorms norms = error_norms(mesh, problem, exact, field);
  solved.aside_seconds = watch.lap();
  solved.true_error = norms.energy;
  solved.true_energy = exact.squared_energy ? std::sqrt(*exact.squared_energy) : norms.exact_energy;
  solved.vertex_fields.push_back(
      {"error", 1, nodal_error(mesh.mesh, exact, vertex_values(mesh, field))});
}

void add_point_values(const FeMesh& mesh, const ScalarField& field,
                      const std::vector<NamedPoint>& points, SolvedModel& solved) {
  if (points.empty()) return;
  PointLocation location(mesh);
  for (const NamedPoint& p : points)
    solved.values.push_back({p.name, values_at(location, field, {{p.at}}).front()});
}

SolvedGoal solved_goal(const FeMesh& mesh, const ScalarProblem& problem,
                       const ScalarSolution& solution, const Goal& goal,
                       const ScalarOptions& options) {
  const ScalarProblem dual = dual_problem(mesh, problem, goal);
  const ScalarSolution z = solve_scalar(mesh, dual, options);
  SolvedGoal result{
      goal_value(mesh, problem, solution, goal), scalar_flux(mesh, dual, z.field), {}, {}};
  if (options.order == 1) result.dual_curvature_values = vertex_values(mesh, z.field);
  return result;
}

/// A solution with a mesh of its own, to be carried to another one.
class Memory {
 public:
  Memory(const FeMesh& mesh, ScalarField field)
      : mesh_(mesh.mesh),
        fe_{mesh_, mesh.edges, mesh.edge_points, mesh.edge_is_bent, mesh.curve_tangents},
        field_(std::move(field)) {}

  ScalarField on(const FeMesh& target) const {
    PointLocation location(fe_);
    return carried(location, field_, target, field_.order);
  }

 private:
  Mesh mesh_;
  FeMesh fe_;  ///< a view of mesh_
  ScalarField field_;
};

/// Solves with the last solution, if there is one, as initial guess; remembers the new one where an
/// iterative method found it.
std::shared_ptr<const ScalarSolution> solve_with_guess(const FeMesh& mesh,
                                                       const ScalarProblem& problem,
                                                       ScalarOptions options,
                                                       std::unique_ptr<const Memory>& memory,
                                                       const Monitor& monitor) {
  std::optional<ScalarField> guess;
  if (memory) options.guess = &guess.emplace(memory->on(mesh));
  auto solution =
      std::make_shared<const ScalarSolution>(solve_scalar(mesh, problem, options, monitor));
  memory.reset();
  if (solution->linear.iterations > 0)
    memory = std::make_unique<const Memory>(mesh, solution->field);
  return solution;
}

}  // namespace

Model scalar_model(ScalarProblem problem, std::optional<ExactSolution> exact, ScalarOptions options,
                   ModelRequests requests) {
  // Shared with the closures of the results, which evaluate the stresses later.
  const auto shared = std::make_shared<const ScalarProblem>(std::move(problem));
  const auto memory = std::make_shared<std::unique_ptr<const Memory>>();
  return [=](const FeMesh& mesh, const Monitor& monitor) {
    const auto solution = solve_with_guess(mesh, *shared, options, *memory, monitor);
    SolvedModel solved;
    solved.dofs = solution->field.dofs.count();
    solved.order = options.order;
    solved.flux = scalar_flux(mesh, *shared, solution->field);
    solved.extra_energy = reaction_energy(mesh, *shared, solution->field);
    solved.flux_at = [&mesh, shared, solution](const Location& l) {
      return scalar_flux_at(mesh, *shared, solution->field, l.element, l.at);
    };
    solved.state = scalar_point_state(mesh, solution);
    std::vector<double> u = vertex_values(mesh, solution->field);
    if (options.order == 1) solved.curvature_values = u;
    solved.vertex_fields.push_back({"u", 1, std::move(u)});
    if (exact) add_truth(mesh, *shared, *exact, solution->field, solved);
    add_point_values(mesh, solution->field, requests.points, solved);
    solved.values.push_back({"energy", solution->squared_energy});
    if (requests.goal) solved.goal = solved_goal(mesh, *shared, *solution, *requests.goal, options);
    return solved;
  };
}

}  // namespace anisofront
