#include <algorithm>
#include <cmath>
#include <memory>

#include "adapt/model.hpp"

namespace anisofront {
namespace {

void add_fields(const std::vector<PlateState>& states, SolvedModel& solved) {
  std::vector<double> w, rotation, moments, shear;
  for (const PlateState& s : states) {
    w.push_back(s.w);
    rotation.insert(rotation.end(), {s.rotation.x, s.rotation.y});
    moments.insert(moments.end(), {s.moments.xx, s.moments.yy, s.moments.xy});
    shear.insert(shear.end(), {s.shear.x, s.shear.y});
  }
  solved.vertex_fields = {{"deflection", 1, std::move(w)},
                          {"rotation", 2, std::move(rotation)},
                          {"moments", 3, std::move(moments)},
                          {"shear", 2, std::move(shear)}};
}

void add_values(const FeMesh& mesh, const PlateProblem& problem, const PlateSolution& solution,
                const std::vector<PlateState>& states, const std::vector<NamedPoint>& points,
                SolvedModel& solved) {
  if (!points.empty()) {
    PointLocation location(mesh);
    for (const NamedPoint& p : points) {
      const Location l = location.nearest(p.at);
      solved.values.push_back({p.name, plate_state(mesh, problem, solution, l.element, l.at).w});
    }
  }
  double deflection = 0, shear = 0;
  for (const PlateState& s : states) {
    deflection = std::max(deflection, std::abs(s.w));
    shear = std::max(shear, norm(s.shear));
  }
  solved.values.push_back({"energy", solution.energy.total()});
  solved.values.push_back({"largest deflection", deflection});
  solved.values.push_back({"largest shear", shear});
}

/// Both rotations at the vertices, from which the moments of first-order elements come.
std::vector<double> vertex_rotations(const std::vector<PlateState>& states) {
  std::vector<double> rotations;
  for (const PlateState& s : states)
    rotations.insert(rotations.end(), {s.rotation.x, s.rotation.y});
  return rotations;
}

/// `flux`: of the solution. What the dual would warn of the solution has warned of.
SolvedGoal solved_goal(const FeMesh& mesh, const PlateProblem& problem,
                       const PlateSolution& solution, const FluxSamples& flux, const Goal& goal,
                       const PlateOptions& options) {
  const PlateProblem dual = dual_problem(mesh, problem, goal);
  const PlateSolution z = solve_plate(mesh, dual, options);
  SolvedGoal result{goal_value(mesh, problem, solution, goal), plate_flux(mesh, dual, z), {}, {}};
  result.tying = {tying_mismatch(mesh, problem, solution, flux, goal),
                  tying_mismatch(mesh, dual, z, result.dual, goal)};
  if (options.element != PlateElement::mitc)
    result.dual_curvature_values = vertex_rotations(vertex_states(mesh, dual, z));
  return result;
}

}  // namespace

Model plate_model(PlateProblem problem, PlateOptions options, ModelRequests requests) {
  const auto shared = std::make_shared<const PlateProblem>(std::move(problem));
  return [=](const FeMesh& mesh, const Monitor& monitor) {
    const auto solution =
        std::make_shared<const PlateSolution>(solve_plate(mesh, *shared, options, monitor));
    SolvedModel solved;
    solved.dofs = solution->dofs.count();
    solved.order = options.element == PlateElement::mitc ? 2 : 1;
    solved.flux = plate_flux(mesh, *shared, *solution);
    solved.flux_at = [&mesh, shared, solution](const Location& l) {
      return plate_flux_at(mesh, *shared, *solution, l.element, l.at);
    };
    solved.state = plate_point_state(mesh, shared, solution);
    const std::vector<PlateState> states = vertex_states(mesh, *shared, *solution);
    add_fields(states, solved);
    add_values(mesh, *shared, *solution, states, requests.points, solved);
    if (solved.order == 1) {
      solved.curvature_values = vertex_rotations(states);
      solved.curvature_components = 2;
    }
    if (requests.goal)
      solved.goal = solved_goal(mesh, *shared, *solution, solved.flux, *requests.goal, options);
    return solved;
  };
}

}  // namespace anisofront
