#include <algorithm>
#include <memory>

#include <spdlog/fmt/fmt.h>

#include "drivers/problem/element_patch.hpp"
#include "drivers/problem/scalar_setup.hpp"
#include "drivers/problem/solved.hpp"
#include "drivers/study/domain_names.hpp"
#include "solver/scalar/boundary_flux.hpp"
#include "solver/scalar/norms.hpp"
#include "solver/scalar/solve_scalar.hpp"

namespace anisofront {
namespace {

/// One solved problem; lives as long as its states are asked for.
struct ScalarRun {
  const FeMesh& mesh;
  std::optional<ExactSolution> exact;
  ScalarProblem problem;
  ScalarSolution solution;
  int threads = 0;
};

std::vector<double> vertex_values(const ScalarRun& run) {
  const auto& values = run.solution.field.values;
  return {values.begin(), values.begin() + static_cast<long>(run.mesh.mesh.points.size())};
}

/// Means over the elements around each vertex.
std::vector<Vector> vertex_gradients(const ScalarRun& run) {
  const ElementPatches patches(run.mesh);
  std::vector<Vector> gradients(run.mesh.mesh.points.size());
  for (std::size_t v = 0; v < gradients.size(); ++v) {
    const auto places = patches.around_vertex(static_cast<Index>(v));
    const double share = 1. / static_cast<double>(places.size());
    for (const Location& place : places)
      gradients[v] =
          gradients[v] +
          share * scalar_state(run.mesh, run.solution.field, place.element, place.at).gradient;
  }
  return gradients;
}

std::vector<FileField> fields_of(const ScalarRun& run) {
  const std::vector<double> u = vertex_values(run);
  std::vector<FileField> fields{{"u", 1, u}, vector_field("gradient", vertex_gradients(run))};
  if (!run.exact) return fields;
  FileField error{"error", 1, {}};
  for (std::size_t v = 0; v < u.size(); ++v)
    error.values.push_back(run.exact->value(run.mesh.mesh.points[v]) - u[v]);
  fields.push_back(std::move(error));
  return fields;
}

Json estimate_of(const ScalarRun& run) {
  return estimate_json(estimate_by_recovery(run.mesh, run.problem, run.solution.field));
}

Json error_of(const ScalarRun& run) {
  if (!run.exact) return nullptr;
  const ErrorNorms norms =
      error_norms(run.mesh, run.problem, *run.exact, run.solution.field, run.threads);
  return {{"l2", norms.l2},
          {"h1", norms.h1},
          {"energy", norms.energy},
          {"relative_energy", norms.relative_energy()}};
}

Json fluxes_of(const ScalarRun& run, const Domain& domain) {
  Json fluxes = Json::array();
  std::vector<Index> done;
  for (const Index c : boundary_curves(domain)) {
    const DomainCurve& curve = domain.curves[static_cast<std::size_t>(c)];
    if (std::find(done.begin(), done.end(), curve.tag) != done.end()) continue;
    done.push_back(curve.tag);
    fluxes.push_back(
        {{"curve", curve.name},
         {"flux", total_flux(run.mesh, run.problem, run.solution.field, curve.tag, run.threads)}});
  }
  return fluxes;
}

std::vector<std::pair<std::string, std::string>> summary_of(const Json& totals) {
  std::vector<std::pair<std::string, std::string>> lines;
  lines.emplace_back("energy", fmt::format("{:.8g} = int a |grad u|^2 + c u^2",
                                           totals["squared_energy"].get<double>()));
  const Json& error = totals["error"];
  if (error.is_object())
    lines.emplace_back(
        "error", fmt::format("{:.4g} of the energy norm, {:.4g} in L2",
                             error["relative_energy"].get<double>(), error["l2"].get<double>()));
  lines.emplace_back("estimate", estimate_text(totals["estimate"]));
  for (const Json& flux : totals["fluxes"])
    lines.emplace_back("flux", fmt::format("{:.8g} out through {}", flux["flux"].get<double>(),
                                           flux["curve"].get<std::string>()));
  return lines;
}

ScalarSolution solution_of(const Study& study, const FeMesh& mesh, const ScalarProblem& problem,
                           const Monitor& monitor) {
  ScalarOptions options;
  options.order = study.problem->order;
  options.threads = study.solver.threads;
  options.linear = linear_options(study.solver);
  return solve_scalar(mesh, problem, options, monitor);
}

}  // namespace

Solved solve_scalar_study(const Study& study, const Domain& domain, const FeMesh& mesh,
                          const Monitor& monitor) {
  auto exact = known_solution(*study.problem);
  ScalarProblem problem = scalar_problem(*study.problem, domain, exact);
  ScalarSolution solution = solution_of(study, mesh, problem, monitor);
  const auto run = std::make_shared<const ScalarRun>(ScalarRun{
      mesh, std::move(exact), std::move(problem), std::move(solution), study.solver.threads});

  Solved solved;
  solved.state = scalar_point_state(mesh, {run, &run->solution});
  solved.vertex_fields = fields_of(*run);
  solved.settings = {{"order", run->solution.field.order}};
  solved.totals = {{"squared_energy", run->solution.squared_energy},
                   {"estimate", estimate_of(*run)},
                   {"error", error_of(*run)},
                   {"fluxes", fluxes_of(*run, domain)}};
  solved.summary = summary_of(solved.totals);
  solved.linear = run->solution.linear;
  solved.assembly_seconds = run->solution.assembly_seconds;
  return solved;
}

}  // namespace anisofront
