#include "drivers/base/text_table.hpp"

#include <algorithm>

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

std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                 bool ends_in_text) {
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i)
    text += i < 2 || (ends_in_text && i + 1 == cells.size())
                ? fmt::format("{:<{}}  ", cells[i], widths[i])
                : fmt::format("{:>{}}  ", cells[i], widths[i]);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + '\n';
}

}  // namespace

std::string as_text(const TextTable& table) {
  const std::vector<std::size_t> widths = column_widths(table);
  std::string text = line(table.header, widths, table.ends_in_text);
  std::vector<std::string> rule;
  for (const std::size_t width : widths) rule.emplace_back(width, '-');
  text += line(rule, widths, table.ends_in_text);
  for (const auto& row : table.rows) text += line(row, widths, table.ends_in_text);
  return text;
}

}  // namespace anisofront
