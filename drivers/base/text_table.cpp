#include "drivers/base/text_table.hpp"

#include <algorithm>
#include <string_view>

#include <spdlog/fmt/fmt.h>

namespace anisofront {
namespace {

std::vector<std::size_t> column_widths(const TextTable& table) {
  std::vector<std::size_t> widths;
  for (const std::string& title : table.header) widths.push_back(title.size());
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  return widths;
}

/// But e: 1e-3 is a number.
constexpr std::string_view kLetters = "abcdfghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

bool holds_letters(const TextTable& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(), [column](const auto& row) {
    return column < row.size() && row[column].find_first_of(kLetters) != std::string::npos;
  });
}

std::vector<bool> text_columns(const TextTable& table) {
  std::vector<bool> is_text(table.header.size());
  for (std::size_t i = 0; i < is_text.size(); ++i)
    is_text[i] = i == 0 || (i == 1 && holds_letters(table, i)) ||
                 (table.ends_in_text && i + 1 == is_text.size());
  return is_text;
}

std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                 const std::vector<bool>& is_text) {
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i)
    text += is_text[i] ? fmt::format("{:<{}}  ", cells[i], widths[i])
                       : fmt::format("{:>{}}  ", cells[i], widths[i]);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + '\n';
}

}  // namespace

std::string as_text(const TextTable& table) {
  const std::vector<std::size_t> widths = column_widths(table);
  const std::vector<bool> is_text = text_columns(table);
  std::string text = line(table.header, widths, is_text);
  std::vector<std::string> rule;
  for (const std::size_t width : widths) rule.emplace_back(width, '-');
  text += line(rule, widths, is_text);
  for (const auto& row : table.rows) text += line(row, widths, is_text);
  return text;
}

}  // namespace anisofront
