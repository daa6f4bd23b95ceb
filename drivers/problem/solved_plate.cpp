#include <memory>

#include <spdlog/fmt/fmt.h>

#include "drivers/problem/plate_setup.hpp"
#include "drivers/problem/solved.hpp"
#include "drivers/study/domain_names.hpp"
#include "solver/plate/solve_plate.hpp"

namespace anisofront {
namespace {

/// One solved plate; lives as long as its states are asked for.
struct PlateRun {
  const FeMesh& mesh;
  PlateProblem problem;
  PlateSolution solution;
};

std::vector<FileField> fields_of(const PlateRun& run) {
  FileField deflection{"deflection", 1, {}}, moments{"moments", 3, {}};
  std::vector<Vector> rotations, shears;
  for (const PlateState& state : vertex_states(run.mesh, run.problem, run.solution)) {
    const Moments& m = state.moments;
    deflection.values.push_back(state.w);
    moments.values.insert(moments.values.end(), {m.xx, m.yy, m.xy});
    rotations.push_back(state.rotation);
    shears.push_back(state.shear);
  }
  return {std::move(deflection), vector_field("rotation", rotations), std::move(moments),
          vector_field("shear", shears)};
}

Json reactions_of(const PlateSolution& solution, const Domain& domain) {
  Json reactions = Json::array();
  for (const PlateReaction& reaction : solution.reactions)
    reactions.push_back(
        {{"curve", reaction.tag == 0 ? Json(nullptr) : Json(curve_name(domain, reaction.tag))},
         {"force", reaction.force},
         {"moment", {reaction.moment.x, reaction.moment.y}}});
  return reactions;
}

Json totals_of(const PlateRun& run, const Domain& domain) {
  const PlateSolution& solution = run.solution;
  return {{"energy",
           {{"bending", solution.energy.bending},
            {"shear", solution.energy.shear},
            {"total", solution.energy.total()}}},
          {"work", solution.work},
          {"load", solution.load},
          {"reactions", reactions_of(solution, domain)},
          {"estimate", estimate_json(estimate_by_recovery(run.mesh, run.problem, solution))}};
}

std::vector<std::pair<std::string, std::string>> summary_of(const Json& totals) {
  const Json& energy = totals["energy"];
  std::vector<std::pair<std::string, std::string>> lines{
      {"energy", fmt::format("{:.8g} (bending {:.6g}, shear {:.6g}); half the work {:.8g}",
                             energy["total"].get<double>(), energy["bending"].get<double>(),
                             energy["shear"].get<double>(), totals["work"].get<double>())},
      {"estimate", estimate_text(totals["estimate"])},
      {"load", fmt::format("{:.8g}", totals["load"].get<double>())}};
  for (const Json& reaction : totals["reactions"]) {
    if (reaction["force"] == 0.) continue;
    const Json& curve = reaction["curve"];
    lines.emplace_back("reaction",
                       fmt::format("{:.8g} at {}", reaction["force"].get<double>(),
                                   curve.is_null() ? "points" : curve.get<std::string>()));
  }
  return lines;
}

PlateSolution solution_of(const Study& study, const FeMesh& mesh, const PlateProblem& problem,
                          const Monitor& monitor) {
  PlateOptions options;
  options.element = study.plate->element;
  options.threads = study.solver.threads;
  options.linear = linear_options(study.solver);
  return solve_plate(mesh, problem, options, monitor);
}

}  // namespace

Solved solve_plate_study(const Study& study, const Domain& domain, const FeMesh& mesh,
                         const Monitor& monitor) {
  PlateProblem problem = plate_problem(*study.plate, domain, monitor);
  PlateSolution solution = solution_of(study, mesh, problem, monitor);
  const auto run =
      std::make_shared<const PlateRun>(PlateRun{mesh, std::move(problem), std::move(solution)});

  Solved solved;
  solved.state = plate_point_state(mesh, {run, &run->problem}, {run, &run->solution});
  solved.vertex_fields = fields_of(*run);
  solved.settings = {{"element", name_of(kPlateElementNames, study.plate->element)}};
  solved.totals = totals_of(*run, domain);
  solved.summary = summary_of(solved.totals);
  solved.linear = run->solution.linear;
  solved.assembly_seconds = run->solution.assembly_seconds;
  return solved;
}

}  // namespace anisofront
