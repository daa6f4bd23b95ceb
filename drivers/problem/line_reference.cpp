#include "drivers/problem/line_reference.hpp"

#include <algorithm>
#include <cmath>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "drivers/problem/reference_file.hpp"
#include "drivers/problem/scalar_setup.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

std::vector<std::string> all_names(const Quantities& quantities) {
  std::vector<std::string> names = quantities.at_point;
  names.insert(names.end(), quantities.along_line.begin(), quantities.along_line.end());
  return names;
}

NumberTable with_columns(const std::vector<std::string>& quantities) {
  NumberTable table{{"s"}, {}};
  table.columns.insert(table.columns.end(), quantities.begin(), quantities.end());
  return table;
}

/// The expressions of a reference, then those of `where`.
ExpressionProgram program_of(const LineReference& reference, const ExpressionNames& names) {
  std::vector<NamedExpression> all;
  for (const NamedExpression& quantity : reference.quantities)
    all.push_back({{}, quantity.expression});
  all.insert(all.end(), names.where.begin(), names.where.end());
  return ExpressionProgram({"x", "y", "s"}, names.constants, std::move(all));
}

double finite(double value, const ExpressionText& text, Point p, double s) {
  if (std::isfinite(value)) return value;
  throw InputError(fmt::format("{} = \"{}\" is {} at {}, s = {:.9g}; it must be finite on the line",
                               text.place, text.text, value, coordinates(p), s));
}

NumberTable by_expressions(const LineReference& reference, const ExpressionNames& names,
                           const std::vector<std::string>& known, const LinePoints& line) {
  NumberTable table = with_columns({});
  for (const auto& [name, expression] : reference.quantities) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw UsageError(fmt::format("{}: unknown quantity \"{}\"{}", expression.place, name,
                                   name_proposal(name, known)));
    table.columns.push_back(name);
  }
  ExpressionProgram program = program_of(reference, names);
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Point p = line.points[i];
    const double s = line.lengths[i];
    const std::vector<double>& values = program.evaluate({p.x, p.y, s});
    std::vector<double> row{s};
    for (std::size_t k = 0; k < reference.quantities.size(); ++k)
      row.push_back(finite(values[k], reference.quantities[k].expression, p, s));
    table.rows.push_back(std::move(row));
  }
  return table;
}

NumberTable by_exact_solution(const ExactSolution& exact, const Quantities& quantities,
                              const LinePoints& line) {
  NumberTable table = with_columns(all_names(quantities));
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Vector gradient = exact.gradient(line.points[i]);
    const std::vector<double> state{exact.value(line.points[i]), gradient.x, gradient.y};
    const std::vector<double> along = quantities.along(state, line.tangents[i]);
    std::vector<double> row{line.lengths[i]};
    row.insert(row.end(), state.begin(), state.end());
    row.insert(row.end(), along.begin(), along.end());
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Quantities study_quantities(const Study& study) {
  return study.plate ? plate_quantities() : scalar_quantities();
}

std::optional<NumberTable> line_reference(const Study& study, const LineRequest& request,
                                          const LinePoints& line) {
  const Quantities quantities = study_quantities(study);
  if (!request.reference) {
    const auto exact = study.problem ? known_solution(*study.problem) : std::nullopt;
    if (!exact) return {};
    return by_exact_solution(*exact, quantities, line);
  }
  const LineReference& reference = *request.reference;
  if (!reference.file.empty())
    return read_reference_file(beside_study(study.file, reference.file), all_names(quantities),
                               reference.place);
  return by_expressions(reference, study.plate ? study.plate->names : study.problem->names,
                        all_names(quantities), line);
}

}  // namespace anisofront
