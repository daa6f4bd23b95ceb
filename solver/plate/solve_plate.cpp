#include "solver/plate/solve_plate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <omp.h>

#include "mesher/geometry/error.hpp"
#include "solver/plate/plate_loads.hpp"
#include "solver/plate/plate_supports.hpp"
#include "solver/plate/plate_text.hpp"

namespace anisofront {
namespace {

/// Point supports that carry less than this share of the loads carry none.
constexpr double kUnloadedPin = 1e-6;

void require_shapes(const FeMesh& mesh, PlateElement element) {
  if (element == PlateElement::mitc4 && !mesh.mesh.triangles.empty())
    throw UsageError("the mesh has triangles, mitc4 is for quadrilaterals only: use mitc");
  if (element == PlateElement::arnold_falk && !mesh.mesh.quads.empty())
    throw UsageError("the mesh has quadrilaterals, arnold-falk is for triangles only: use mitc");
}

void warn_of_polygons(const FeMesh& mesh, const PlateProblem& problem,
                      const std::vector<Index>& smooth_joints, const Monitor& monitor) {
  for (std::size_t s = 0; s < problem.supports.size(); ++s) {
    const PlateSupport& support = problem.supports[s];
    if (smooth_joints[s] == 0 || !held_components(support.kind).tangential_rotation) continue;
    monitor.warning("the support on " + describe_tag(mesh.mesh, 1, support.tag) +
                    " holds the rotation along an edge that is a polygon in place of a curve (" +
                    std::to_string(smooth_joints[s]) +
                    " smooth joints): on finer polygons the solution may tend to that of another "
                    "problem (Babuska's paradox); give the curve, so that elements are bent, or "
                    "use a soft support");
  }
}

void warn_of_point_loads(const PlateProblem& problem, const Monitor& monitor) {
  double thickness = problem.material.thickness;
  for (const auto& [tag, own] : problem.regions) thickness = std::max(thickness, own.thickness);
  for (const PlatePointLoad& load : problem.point_loads)
    monitor.warning("the deflection below the point load at " + describe(load.at) +
                    " grows without bound as the mesh gets finer: read it at least " +
                    describe(5 * thickness) +
                    " (five thicknesses) away, or spread the load over a patch");
}

void warn_of_loaded_pins(const std::vector<PlateReaction>& reactions, double loads,
                         const Monitor& monitor) {
  for (const PlateReaction& reaction : reactions)
    if (reaction.tag == 0 && reaction.largest > kUnloadedPin * loads)
      monitor.warning("point supports carry up to " + describe(reaction.largest) +
                      ": the plate sinks without bound there as the mesh gets finer; support a "
                      "curve instead, or balance the loads of a free plate");
}

std::vector<double> to_vector(const Eigen::VectorXd& values) {
  return {values.data(), values.data() + values.size()};
}

/// Summed in the order of the elements, whatever the threads.
PlateEnergy energy_of(const FeMesh& mesh, const PlateProblem& problem,
                      const PlateSolution& solution, int threads) {
  std::vector<PlateEnergy> energies(mesh.element_count());
#pragma omp parallel for num_threads(threads > 0 ? threads : omp_get_max_threads())
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    energies[e] =
        element_energy(solution.element, problem.material_in(element.region), element,
                       local_values(mesh, solution.dofs, element, solution.values, solution.inner));
  }
  PlateEnergy sum;
  for (const PlateEnergy& own : energies) {
    sum.bending += own.bending;
    sum.shear += own.shear;
  }
  return sum;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

LinearSystem loaded_system(const FeMesh& mesh, const PlateProblem& problem,
                           const PlateOptions& options, const ElementKernel& kernel,
                           PlateSolution& solution) {
  const auto start = std::chrono::steady_clock::now();
  LinearSystem system = assemble(mesh, solution.dofs, kernel, options.threads);
  add_edge_loads(mesh, solution.dofs, options.element, problem, system.rhs);
  add_point_loads(mesh, solution.dofs, options.element, problem, system.rhs);
  solution.assembly_seconds = seconds_since(start);
  return system;
}

/// Solves under the conditions; values in x and y components.
Eigen::VectorXd solve_under(const PlateConditions& conditions, LinearSystem system,
                            const PlateOptions& options, const Monitor& monitor,
                            LinearReport& report) {
  rotate_to_frames(conditions.frames, system);
  impose(conditions.constraints, system);
  LinearResult result = solve_linear(system, options.linear, monitor);
  rotate_back(conditions.frames, result.solution);
  report = std::move(result.report);
  return std::move(result.solution);
}

}  // namespace

PlateSolution solve_plate(const FeMesh& mesh, const PlateProblem& problem,
                          const PlateOptions& options, const Monitor& monitor) {
  validate(problem, mesh);
  require_shapes(mesh, options.element);
  PlateSolution solution;
  solution.element = options.element;
  solution.dofs = make_dof_map(mesh, plate_layout(options.element));
  const auto [nodes, joints] = support_nodes(mesh, options.element, problem);
  const PlateConditions conditions = plate_conditions(nodes, solution.dofs, options.element);
  require_supported(mesh, solution.dofs, options.element, conditions);
  warn_of_polygons(mesh, problem, joints, monitor);
  warn_of_point_loads(problem, monitor);

  const ElementKernel kernel = plate_kernel(options.element, problem);
  LinearSystem system = loaded_system(mesh, problem, options, kernel, solution);
  const LoadResultant loads = resultant(mesh, solution.dofs, options.element, system.rhs);
  const Eigen::VectorXd rhs = system.rhs;
  const SupportRows rows = support_rows(system, nodes, solution.dofs, options.element);
  const Eigen::VectorXd values =
      solve_under(conditions, std::move(system), options, monitor, solution.linear);

  solution.values = to_vector(values);
  solution.inner = inner_values(mesh, solution.dofs, kernel, values, options.threads);
  solution.energy = energy_of(mesh, problem, solution, options.threads);
  SupportForces forces = support_forces(rows, nodes, problem, values);
  solution.work = 0.5 * (rhs.dot(values) + forces.work);
  solution.load = loads.force;
  solution.load_moment = loads.moment;
  solution.reactions = std::move(forces.reactions);
  warn_of_loaded_pins(solution.reactions, loads.absolute, monitor);
  return solution;
}

}  // namespace anisofront
