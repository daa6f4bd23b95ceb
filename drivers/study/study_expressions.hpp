#pragma once

#include <array>
#include <optional>
#include <string>

#include "drivers/study/toml_table.hpp"

namespace anisofront {

/// The keys constants = { eps = 0.01 } and where = { r = "sqrt(x^2 + y^2)" } of a table.
Constants read_constants(TomlTable& table);
std::vector<NamedExpression> read_where(TomlTable& table);
ExpressionNames read_names(TomlTable& table);

/// The expression of a key, compiled once so that mistakes are found before anything runs.
std::optional<ExpressionText> read_expression(TomlTable& table, const std::string& key,
                                              const ExpressionNames& names);

/// The same; refuses a number (or an expression of constants) that is not positive, or negative.
std::optional<ExpressionText> read_positive(TomlTable& table, const std::string& key,
                                            const ExpressionNames& names);
std::optional<ExpressionText> read_not_negative(TomlTable& table, const std::string& key,
                                                const ExpressionNames& names);

/// Two expressions or numbers: ["x part", "y part"].
std::optional<std::array<ExpressionText, 2>> read_vector(TomlTable& table, const std::string& key,
                                                         const ExpressionNames& names);

/// A number, or an expression of constants. Throws UsageError when it varies with x or y.
std::optional<double> read_number(TomlTable& table, const std::string& key,
                                  const ExpressionNames& names);
std::optional<double> read_positive_number(TomlTable& table, const std::string& key,
                                           const ExpressionNames& names);

}  // namespace anisofront
