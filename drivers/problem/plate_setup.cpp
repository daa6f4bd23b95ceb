#include "drivers/problem/plate_setup.hpp"

#include <algorithm>

#include "drivers/base/text.hpp"
#include "drivers/study/domain_names.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

void add_condition(const PlateBoundaryText& text, Index tag, const ExpressionNames& names,
                   PlateProblem& problem) {
  const auto value = [&](const std::optional<ExpressionText>& expression) {
    return expression ? coefficient(*expression, names) : Coefficient(0);
  };
  problem.supports.push_back({tag, text.support, value(text.deflection)});
  if (text.shear || text.moment || text.twist)
    problem.edge_loads.push_back({tag, value(text.shear), value(text.moment), value(text.twist)});
}

bool has_support(const PlateProblem& problem, Index tag) {
  return std::any_of(problem.supports.begin(), problem.supports.end(),
                     [&](const PlateSupport& support) { return support.tag == tag; });
}

void warn_of_free_curves(const PlateProblem& problem, const Domain& domain,
                         const Monitor& monitor) {
  std::vector<std::string> names;
  for (const Index c : boundary_curves(domain)) {
    const DomainCurve& curve = domain.curves[static_cast<std::size_t>(c)];
    if (!has_support(problem, curve.tag)) names.push_back(curve.name);
  }
  if (!names.empty())
    monitor.warning("no condition mentions " + joined(names) +
                    ": free edges (write \"free\" if that is meant)");
}

}  // namespace

PlateProblem plate_problem(const PlateProblemText& text, const Domain& domain,
                           const Monitor& monitor) {
  PlateProblem problem;
  problem.material = text.material;
  problem.load = coefficient(text.load, text.names);
  for (const PlateRegionText& region : text.regions) {
    const Index tag = region_tag(domain, region.region, region.place);
    problem.regions.emplace_back(tag, region.material);
    if (region.load) problem.load.set(tag, coefficient(*region.load, text.names));
  }
  for (const PlateBoundaryText& boundary : text.boundary) {
    const Index tag = curve_tag(domain, boundary.curve, boundary.place);
    if (has_support(problem, tag))
      throw UsageError(boundary.place + ": the edges of \"" + boundary.curve +
                       "\" have a condition already, under another name of the same group");
    add_condition(boundary, tag, text.names, problem);
  }
  problem.point_loads = text.point_loads;
  problem.point_supports = text.point_supports;
  warn_of_free_curves(problem, domain, monitor);
  return problem;
}

}  // namespace anisofront
