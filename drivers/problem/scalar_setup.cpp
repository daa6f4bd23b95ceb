#include "drivers/problem/scalar_setup.hpp"

#include "drivers/study/domain_names.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

void add_condition(const ScalarBoundaryText& text, Index tag, const ExpressionNames& names,
                   ScalarProblem& problem) {
  if (text.value) {
    problem.dirichlet.push_back({tag, coefficient(*text.value, names)});
    return;
  }
  const auto value = [&](const std::optional<ExpressionText>& expression) {
    return expression ? coefficient(*expression, names) : Coefficient(0);
  };
  problem.fluxes.push_back({tag, value(text.flux), value(text.transfer)});
}

void set_region(const ScalarRegionText& text, Index tag, const ExpressionNames& names,
                ScalarProblem& problem) {
  const auto set = [&](RegionCoefficient& target, const std::optional<ExpressionText>& expression) {
    if (expression) target.set(tag, coefficient(*expression, names));
  };
  set(problem.diffusion, text.diffusion);
  set(problem.reaction, text.reaction);
  set(problem.source, text.source);
  if (!text.velocity) return;
  set(problem.velocity_x, (*text.velocity)[0]);
  set(problem.velocity_y, (*text.velocity)[1]);
}

/// Two names of one tag would be two conditions on the same edges.
void require_distinct(const ScalarProblem& problem, Index tag, const ScalarBoundaryText& text) {
  bool is_known = false;
  for (const DirichletCondition& other : problem.dirichlet) is_known |= other.tag == tag;
  for (const FluxCondition& other : problem.fluxes) is_known |= other.tag == tag;
  if (is_known)
    throw UsageError(text.place + ": the edges of \"" + text.curve +
                     "\" have a condition already, under another name of the same group");
}

}  // namespace

std::optional<ExactSolution> known_solution(const ScalarProblemText& text) {
  if (text.exact.empty()) return {};
  return exact_solution(text.exact, exact_parameters(text));
}

ScalarProblem scalar_problem(const ScalarProblemText& text, const Domain& domain,
                             const std::optional<ExactSolution>& exact) {
  const ExpressionNames& names = text.names;
  ScalarProblem problem;
  problem.diffusion = coefficient(text.diffusion, names);
  problem.reaction = coefficient(text.reaction, names);
  if (exact) problem.source = exact->source;
  if (text.source) problem.source = coefficient(*text.source, names);
  if (text.velocity) {
    problem.velocity_x = coefficient((*text.velocity)[0], names);
    problem.velocity_y = coefficient((*text.velocity)[1], names);
  }
  for (const ScalarRegionText& region : text.regions)
    set_region(region, region_tag(domain, region.region, region.place), names, problem);
  for (const ScalarBoundaryText& condition : text.boundary) {
    const Index tag = curve_tag(domain, condition.curve, condition.place);
    require_distinct(problem, tag, condition);
    if (condition.is_exact)
      problem.dirichlet.push_back({tag, exact.value().value});
    else
      add_condition(condition, tag, names, problem);
  }
  for (const ScalarPointText& point : text.points)
    problem.points.push_back({point.at, point.value});
  return problem;
}

}  // namespace anisofront
