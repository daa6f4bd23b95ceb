#include "drivers/study/study_problem.hpp"

#include <algorithm>
#include <numbers>

#include "drivers/study/study_expressions.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

bool is_exact(TomlTable entry) {
  const auto value = entry.expression("value");
  return value && value->text == "exact";
}

ScalarBoundaryText read_condition(TomlTable entry, const std::string& curve,
                                  const ExpressionNames& names) {
  ScalarBoundaryText condition;
  condition.curve = curve;
  condition.place = entry.place();
  condition.is_exact = is_exact(entry);
  condition.value =
      condition.is_exact ? entry.expression("value") : read_expression(entry, "value", names);
  condition.flux = read_expression(entry, "flux", names);
  auto robin = entry.table("robin");
  const int given = condition.value.has_value() + condition.flux.has_value() + robin.has_value();
  if (robin) {
    const auto transfer = read_not_negative(*robin, "transfer", names);
    condition.transfer = robin->required(transfer, "transfer");
    condition.flux = read_expression(*robin, "flux", names);
    robin->finish();
  }
  entry.finish();
  if (given != 1)
    entry.fail({},
               "expected exactly one of value = ..., flux = ... and robin = { transfer = ..., "
               "flux = ... }");
  return condition;
}

std::vector<ScalarBoundaryText> read_boundary(TomlTable& problem, const ExpressionNames& names) {
  std::vector<ScalarBoundaryText> conditions;
  auto table = problem.table("boundary");
  if (!table) return conditions;
  for (const std::string& curve : table->keys())
    conditions.push_back(read_condition(table->required(table->table(curve), curve), curve, names));
  return conditions;
}

std::vector<ScalarRegionText> read_regions(TomlTable& problem, const ExpressionNames& names) {
  std::vector<ScalarRegionText> regions;
  auto table = problem.table("regions");
  if (!table) return regions;
  for (const std::string& name : table->keys()) {
    TomlTable entry = table->required(table->table(name), name);
    regions.push_back({name, read_positive(entry, "diffusion", names),
                       read_not_negative(entry, "reaction", names),
                       read_expression(entry, "source", names),
                       read_vector(entry, "velocity", names), entry.place()});
    entry.finish();
  }
  return regions;
}

std::vector<ScalarPointText> read_points(TomlTable& problem, const ExpressionNames& names) {
  std::vector<ScalarPointText> points;
  for (TomlTable& entry : problem.tables("points")) {
    points.push_back({entry.required(entry.point("at"), "at"),
                      entry.required(read_number(entry, "value", names), "value")});
    entry.finish();
  }
  return points;
}

int read_order(TomlTable& table) {
  const Index order = table.integer("order").value_or(1);
  if (order != 1 && order != 2)
    table.fail("order",
               "found " + std::to_string(order) + ", expected 1 (linear) or 2 (quadratic)");
  return static_cast<int>(order);
}

bool is_constant(const std::optional<std::array<ExpressionText, 2>>& vector,
                 const ExpressionNames& names) {
  return !vector || (constant_value((*vector)[0], names) && constant_value((*vector)[1], names));
}

/// A known solution is one of constant coefficients in the whole domain.
void check_exact(TomlTable& table, const ScalarProblemText& problem) {
  const bool asks = std::any_of(problem.boundary.begin(), problem.boundary.end(),
                                [](const ScalarBoundaryText& b) { return b.is_exact; });
  if (problem.exact.empty()) {
    if (asks) table.fail("boundary", "value = \"exact\" needs exact = \"NAME\"");
    return;
  }
  if (!problem.regions.empty())
    table.fail("exact", "the known solutions are those of one region; leave regions out");
  if (!constant_value(problem.diffusion, problem.names) ||
      !constant_value(problem.reaction, problem.names) ||
      !is_constant(problem.velocity, problem.names))
    table.fail("exact", "the known solutions need constant diffusion, reaction and velocity");
  try {
    exact_solution(problem.exact, exact_parameters(problem));
  } catch (const UsageError& error) {
    table.fail("exact", error.what());
  }
}

/// front = { point, angle (degrees), radius, width }.
Front read_front(TomlTable& problem, const ExpressionNames& names) {
  Front front;
  auto table = problem.table("front");
  if (!table) return front;
  front.point = table->point("point").value_or(front.point);
  front.angle = read_number(*table, "angle", names).value_or(0) * std::numbers::pi / 180;
  front.radius = read_positive_number(*table, "radius", names).value_or(0);
  front.width = read_positive_number(*table, "width", names).value_or(front.width);
  table->finish();
  return front;
}

}  // namespace

bool ScalarProblemText::has_convection() const {
  return velocity || std::any_of(regions.begin(), regions.end(),
                                 [](const ScalarRegionText& r) { return r.velocity.has_value(); });
}

ExactParameters exact_parameters(const ScalarProblemText& problem) {
  const auto value = [&](const ExpressionText& text) {
    return constant_value(text, problem.names).value_or(0);
  };
  ExactParameters parameters{value(problem.diffusion), value(problem.reaction), {}, problem.front};
  if (problem.velocity)
    parameters.velocity = {value((*problem.velocity)[0]), value((*problem.velocity)[1])};
  return parameters;
}

ScalarProblemText parse_scalar_problem(TomlTable table) {
  ScalarProblemText problem;
  problem.place = table.place();
  problem.names = read_names(table);
  const ExpressionNames& names = problem.names;
  problem.order = read_order(table);
  problem.diffusion = read_positive(table, "diffusion", names).value_or(problem.diffusion);
  problem.reaction = read_not_negative(table, "reaction", names).value_or(problem.reaction);
  problem.source = read_expression(table, "source", names);
  problem.velocity = read_vector(table, "velocity", names);
  if (table.has("exact")) problem.exact = table.choice("exact", exact_solution_names(), "");
  problem.front = read_front(table, names);
  problem.regions = read_regions(table, names);
  problem.boundary = read_boundary(table, names);
  problem.points = read_points(table, names);
  table.finish();
  check_exact(table, problem);
  return problem;
}

}  // namespace anisofront
