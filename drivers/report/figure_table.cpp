#include "drivers/report/figure_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "drivers/base/text.hpp"

namespace anisofront {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else if (c != '\r')
      parts.back() += c;
  }
  return parts;
}

double number(const std::string& text) {
  double value = std::nan("");
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

NumberTable read_number_table(const std::filesystem::path& path) {
  NumberTable table;
  for (const std::string& line : split(read_text_file(path), '\n')) {
    const std::vector<std::string> cells = split(line, ',');
    if (table.columns.empty()) {
      table.columns = cells;
    } else if (cells.size() >= table.columns.size() && !line.empty()) {
      table.rows.emplace_back();
      for (const std::string& cell : cells) table.rows.back().push_back(number(cell));
    }
  }
  return table;
}

std::optional<std::size_t> column_of(const NumberTable& table, const std::string& name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  if (found == table.columns.end()) return {};
  return static_cast<std::size_t>(found - table.columns.begin());
}

}  // namespace anisofront
