#include "drivers/problem/reference_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

std::string trimmed(const std::string& text) {
  constexpr const char* kBlanks = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line + ",");
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(trimmed(field));
  return fields;
}

/// Reads one file; messages say where in it.
class Reader {
 public:
  Reader(const std::filesystem::path& path, const std::vector<std::string>& quantities,
         const std::string& place)
      : path_(path), quantities_(quantities), place_(place) {}

  NumberTable read() {
    std::istringstream lines(text());
    NumberTable all;
    for (std::string line; std::getline(lines, line);) {
      ++line_;
      line = trimmed(line.substr(0, line.find('#')));
      if (line.empty()) continue;
      if (all.columns.empty())
        all.columns = read_columns(line);
      else
        all.rows.push_back(read_row(line, all.columns));
    }
    if (all.rows.empty()) fail("there is no row of numbers below the names of the columns");
    return s_and_quantities(all);
  }

 private:
  std::string text() const {
    try {
      return read_text_file(path_);
    } catch (const Error& error) {
      throw UsageError(place_ + ": " + error.what());
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw UsageError(fmt::format("{}: {}: line {}: {}", place_, path_.string(), line_, what));
  }

  std::vector<std::string> read_columns(const std::string& line) const {
    std::vector<std::string> columns = fields_of(line);
    std::vector<std::string> known{"s", "x", "y"};
    known.insert(known.end(), quantities_.begin(), quantities_.end());
    for (auto name = columns.begin(); name != columns.end(); ++name) {
      if (std::find(known.begin(), known.end(), *name) == known.end())
        fail(fmt::format("unknown column \"{}\"{}", *name, name_proposal(*name, known)));
      if (std::find(columns.begin(), name, *name) != name)
        fail(fmt::format("the column \"{}\" stands there twice", *name));
    }
    if (std::find(columns.begin(), columns.end(), "s") == columns.end())
      fail("there is no column \"s\", the length from the start of the line");
    if (std::none_of(columns.begin(), columns.end(), [&](const std::string& name) {
          return std::find(quantities_.begin(), quantities_.end(), name) != quantities_.end();
        }))
      fail("expected a quantity beside \"s\": " + joined(quantities_));
    return columns;
  }

  std::vector<double> read_row(const std::string& line, const std::vector<std::string>& columns) {
    const std::vector<std::string> fields = fields_of(line);
    if (fields.size() != columns.size())
      fail(fmt::format("found {} values, expected {}", fields.size(), columns.size()));
    std::vector<double> row;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      row.push_back(number(fields[i], columns[i]));
      if (columns[i] != "s") continue;
      if (row.back() < last_s_)
        fail("s falls; expected lengths from the start of the line, sorted");
      last_s_ = row.back();
    }
    return row;
  }

  double number(const std::string& field, const std::string& column) const {
    double value = 0;
    const char* end = field.data() + field.size();
    const auto [rest, error] = std::from_chars(field.data(), end, value);
    if (error != std::errc() || rest != end || !std::isfinite(value))
      fail(fmt::format("found \"{}\" for {}, expected a finite number", field, column));
    return value;
  }

  static NumberTable s_and_quantities(const NumberTable& all) {
    std::vector<std::size_t> kept;
    const auto keep = [&](bool is_s) {
      for (std::size_t i = 0; i < all.columns.size(); ++i)
        if ((all.columns[i] == "s") == is_s && all.columns[i] != "x" && all.columns[i] != "y")
          kept.push_back(i);
    };
    keep(true);
    keep(false);
    NumberTable table;
    for (const std::size_t i : kept) table.columns.push_back(all.columns[i]);
    for (const std::vector<double>& row : all.rows) {
      table.rows.emplace_back();
      for (const std::size_t i : kept) table.rows.back().push_back(row[i]);
    }
    return table;
  }

  const std::filesystem::path& path_;
  const std::vector<std::string>& quantities_;
  const std::string& place_;
  int line_ = 0;
  double last_s_ = -HUGE_VAL;
};

}  // namespace

NumberTable read_reference_file(const std::filesystem::path& path,
                                const std::vector<std::string>& quantities,
                                const std::string& place) {
  return Reader(path, quantities, place).read();
}

}  // namespace anisofront
