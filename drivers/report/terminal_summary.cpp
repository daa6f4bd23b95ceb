#include "drivers/report/terminal_summary.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "drivers/report/result_tables.hpp"
#include "drivers/report/summary.hpp"

namespace anisofront {
namespace {

constexpr std::size_t kMostVariants = 30;
constexpr std::size_t kLongestLabel = 40;

/// Left out first to last where the terminal is too narrow.
const std::vector<std::string> kLeastInterest{
    "min sJ", "angles",      "NB",  "ND",          "0.5-1.5 %", "l_min",   "l_max",
    "cycles", "unit band %", "min", "effectivity", "dofs",      "estimate"};

std::size_t column_named(const TextTable& table, const std::string& title) {
  const auto found = std::find(table.header.begin(), table.header.end(), title);
  return static_cast<std::size_t>(found - table.header.begin());
}

void erase_column(TextTable& table, std::size_t column) {
  const auto erase = [column](std::vector<std::string>& cells) {
    if (column < cells.size()) cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(column));
  };
  if (column + 1 == table.header.size()) table.ends_in_text = false;
  erase(table.header);
  for (auto& row : table.rows) erase(row);
}

/// What stands in every row of the column; empty when they differ or there are no rows.
std::string common_cell(const TextTable& table, std::size_t column) {
  if (table.rows.empty() || column >= table.header.size()) return {};
  const std::string& first = table.rows.front()[column];
  const bool is_common = std::all_of(table.rows.begin(), table.rows.end(),
                                     [&](const auto& row) { return row[column] == first; });
  return is_common ? first : "";
}

void erase_empty_columns(TextTable& table) {
  for (std::size_t column = table.header.size(); column-- > 1;)
    if (common_cell(table, column) == "-") erase_column(table, column);
}

bool are_equal(const TextTable& table, const std::string& a, const std::string& b) {
  const std::size_t i = column_named(table, a), j = column_named(table, b);
  if (i == table.header.size() || j == table.header.size()) return false;
  return std::all_of(table.rows.begin(), table.rows.end(),
                     [&](const auto& row) { return row[i] == row[j]; });
}

bool is_too_wide(const TextTable& table, int columns) {
  std::istringstream lines(as_text(table));
  for (std::string line; std::getline(lines, line);)
    if (static_cast<int>(line.size()) > columns) return true;
  return false;
}

TextTable fitted(TextTable table, int columns) {
  for (const std::string& title : kLeastInterest) {
    if (!is_too_wide(table, columns)) break;
    for (std::size_t i = column_named(table, title); i < table.header.size();
         i = column_named(table, title))
      erase_column(table, i);
  }
  return table;
}

/// "finished after 5 cycles", or "90 finished after 4 cycles, 6 interrupted".
std::string ends_of(const Json& variants) {
  std::vector<std::pair<std::string, int>> counts;
  for (const Json& variant : variants) {
    const std::string reason = variant["stop_reason"];
    const auto found = std::find_if(counts.begin(), counts.end(),
                                    [&](const auto& count) { return count.first == reason; });
    if (found == counts.end())
      counts.emplace_back(reason, 1);
    else
      ++found->second;
  }
  if (counts.size() == 1) return counts.front().first;
  std::vector<std::string> parts;
  for (const auto& [reason, count] : counts) parts.push_back(fmt::format("{} {}", count, reason));
  return joined(parts);
}

std::string results_text(const Json& history, int columns) {
  TextTable table = result_table(history);
  if (table.rows.empty()) return {};
  erase_empty_columns(table);
  const std::string reason = common_cell(table, column_named(table, "stopped"));
  if (!reason.empty()) {
    erase_column(table, column_named(table, "stopped"));
    erase_column(table, column_named(table, "cycles"));
  }
  if (are_equal(table, "vertices", "dofs")) erase_column(table, column_named(table, "dofs"));
  return as_text(fitted(std::move(table), columns)) + (reason.empty() ? "" : reason + "\n");
}

std::vector<std::string> name_parts(const std::string& name) {
  std::vector<std::string> parts;
  std::istringstream stream(name);
  for (std::string part; std::getline(stream, part, '-');) parts.push_back(part);
  return parts;
}

bool has_settings(const Json& variant, const Json& settings) {
  return std::all_of(settings.items().begin(), settings.items().end(), [&](const auto& setting) {
    return variant["settings"].value(setting.key(), Json()) == setting.value();
  });
}

/// What the names of the compared variants have in common:
/// "0.1-triangle-clamped".
std::string common_name(const Json& variants, const Json& settings) {
  std::vector<std::string> common;
  bool is_first = true;
  for (const Json& variant : variants) {
    if (!has_settings(variant, settings)) continue;
    const std::vector<std::string> parts = name_parts(variant["name"]);
    const auto is_missing = [&](const std::string& part) {
      return std::find(parts.begin(), parts.end(), part) == parts.end();
    };
    if (std::exchange(is_first, false)) common = parts;
    common.erase(std::remove_if(common.begin(), common.end(), is_missing), common.end());
  }
  return joined(common, "-");
}

/// Settings make good labels while they are short.
void shorten_labels(const Json& history, TextTable& table) {
  const bool is_short = std::all_of(table.rows.begin(), table.rows.end(), [](const auto& row) {
    return row.front().size() <= kLongestLabel;
  });
  if (is_short) return;
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    table.rows[i].front() = common_name(history["variants"], history["comparison"][i]["settings"]);
}

/// The columns of the unknowns are the last of a comparison, with a ratio of their own.
void erase_unknowns(TextTable& table) {
  const std::size_t first = column_named(table, "iso dofs");
  while (table.header.size() > first) erase_column(table, table.header.size() - 1);
}

std::string comparison_text(const Json& history, int columns) {
  TextTable table = comparison_table(history);
  if (table.rows.empty()) return {};
  shorten_labels(history, table);
  erase_empty_columns(table);
  const std::size_t errors = column_named(table, "errors");
  const std::string kind = common_cell(table, errors);
  if (!kind.empty()) {
    erase_column(table, errors);
    table.header.front() = kind == "true" ? "at equal true error" : "at equal estimate";
  }
  if (is_too_wide(table, columns) || are_equal(table, "iso vertices", "iso dofs"))
    erase_unknowns(table);
  return as_text(table);
}

std::string values_text(const Json& history, int columns) {
  TextTable table = value_table(history);
  if (table.rows.empty()) return {};
  erase_empty_columns(table);
  while (table.header.size() > 2 && is_too_wide(table, columns))
    erase_column(table, table.header.size() - 1);
  return as_text(table);
}

/// The table of the paper is for prescribed metrics.
std::string paper_text(const Json& history, int columns) {
  Json prescribed = history;
  prescribed["variants"] = Json::array();
  for (const Json& variant : history["variants"]) {
    const bool is_prescribed =
        !variant["cycles"].empty() && variant["cycles"].back()["quality"]["against"] == "exact";
    if (is_prescribed) prescribed["variants"].push_back(variant);
  }
  TextTable table = summary_table(prescribed);
  if (table.rows.empty()) return {};
  erase_empty_columns(table);
  return as_text(fitted(std::move(table), columns));
}

}  // namespace

std::string terminal_summary(const Json& history, int columns) {
  const std::size_t variants = history["variants"].size();
  std::vector<std::string> parts;
  if (variants > kMostVariants) {
    parts.push_back(fmt::format("{} variants: {}\n", variants, ends_of(history["variants"])));
  } else {
    parts.push_back(paper_text(history, columns));
    parts.push_back(results_text(history, columns));
    parts.push_back(values_text(history, columns));
  }
  parts.push_back(comparison_text(history, columns));
  parts.erase(std::remove(parts.begin(), parts.end(), ""), parts.end());
  return joined(parts, "\n");
}

}  // namespace anisofront
