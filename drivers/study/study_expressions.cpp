#include "drivers/study/study_expressions.hpp"

#include <spdlog/fmt/fmt.h>

namespace anisofront {

Constants read_constants(TomlTable& table) {
  Constants constants;
  if (auto names = table.table("constants"))
    for (const std::string& name : names->keys())
      constants.emplace_back(name, names->required(names->number(name), name));
  return constants;
}

std::vector<NamedExpression> read_where(TomlTable& table) {
  std::vector<NamedExpression> where;
  if (auto names = table.table("where"))
    for (const std::string& name : names->keys())
      where.push_back({name, names->required(names->expression(name), name)});
  return where;
}

ExpressionNames read_names(TomlTable& table) { return {read_constants(table), read_where(table)}; }

std::optional<ExpressionText> read_expression(TomlTable& table, const std::string& key,
                                              const ExpressionNames& names) {
  const auto text = table.expression(key);
  if (text) constant_value(*text, names);
  return text;
}

std::optional<ExpressionText> read_positive(TomlTable& table, const std::string& key,
                                            const ExpressionNames& names) {
  const auto text = read_expression(table, key, names);
  const auto value = text ? constant_value(*text, names) : std::nullopt;
  if (value && *value <= 0) table.fail(key, fmt::format("must be positive, found {}", *value));
  return text;
}

std::optional<ExpressionText> read_not_negative(TomlTable& table, const std::string& key,
                                                const ExpressionNames& names) {
  const auto text = read_expression(table, key, names);
  const auto value = text ? constant_value(*text, names) : std::nullopt;
  if (value && *value < 0) table.fail(key, fmt::format("must not be negative, found {}", *value));
  return text;
}

std::optional<std::array<ExpressionText, 2>> read_vector(TomlTable& table, const std::string& key,
                                                         const ExpressionNames& names) {
  if (!table.has(key)) return {};
  const std::vector<ExpressionText> parts = table.expressions(key);
  if (parts.size() != 2)
    table.fail(key, fmt::format("expected two numbers or expressions [\"x part\", \"y part\"], "
                                "found {}",
                                parts.size()));
  for (const ExpressionText& part : parts) constant_value(part, names);
  return {{parts[0], parts[1]}};
}

std::optional<double> read_number(TomlTable& table, const std::string& key,
                                  const ExpressionNames& names) {
  const auto text = table.expression(key);
  if (!text) return {};
  const auto value = constant_value(*text, names);
  if (!value)
    table.fail(key, fmt::format("\"{}\" varies with x or y; expected a number or an expression of "
                                "constants",
                                text->text));
  return value;
}

std::optional<double> read_positive_number(TomlTable& table, const std::string& key,
                                           const ExpressionNames& names) {
  const auto value = read_number(table, key, names);
  if (value && *value <= 0) table.fail(key, fmt::format("must be positive, found {}", *value));
  return value;
}

}  // namespace anisofront
