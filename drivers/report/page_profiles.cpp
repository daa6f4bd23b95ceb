#include "drivers/report/page_profiles.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <sstream>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

/// Seven digits are finer than a chart and make the page a third smaller.
Json number_json(const std::string& field) {
  const double value = std::strtod(field.c_str(), nullptr);
  if (field.empty() || !std::isfinite(value)) return nullptr;
  return std::strtod(fmt::format("{:.7g}", value).c_str(), nullptr);
}

Json row_json(const std::string& line) {
  Json row = Json::array();
  for (const std::string& field : fields_of(line)) row.push_back(number_json(field));
  return row;
}

/// {"columns", "rows"} of a file of numbers under a line of names; rows of another width are left
/// out.
Json table_json(const fs::path& path) {
  std::istringstream lines(read_text_file(path));
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> columns = fields_of(line);
  Json rows = Json::array();
  while (std::getline(lines, line)) {
    Json row = row_json(line);
    if (row.size() == columns.size()) rows.push_back(std::move(row));
  }
  return {{"columns", columns}, {"rows", std::move(rows)}};
}

/// The files of one line.
struct LineFiles {
  std::map<int, fs::path> cycles;
  std::optional<fs::path> reference;
};

/// Takes "cycle-3-edge.csv" and "reference-edge.csv" for files of the line "edge".
void add_file(std::map<std::string, LineFiles>& lines, const fs::path& path) {
  constexpr std::string_view kCycle = "cycle-", kReference = "reference-";
  const std::string stem = path.stem().string();
  if (path.extension() != ".csv") return;
  if (stem.starts_with(kReference)) lines[stem.substr(kReference.size())].reference = path;
  if (!stem.starts_with(kCycle)) return;
  int cycle = -1;
  const char* const end = stem.data() + stem.size();
  const auto number = std::from_chars(stem.data() + kCycle.size(), end, cycle);
  if (number.ec == std::errc() && cycle >= 0 && number.ptr != end && *number.ptr == '-')
    lines[std::string(number.ptr + 1, end)].cycles[cycle] = path;
}

Json line_json(const std::string& name, const LineFiles& files) {
  Json line{{"name", name}, {"columns", Json::array()}, {"cycles", Json::array()}};
  for (const auto& [cycle, path] : files.cycles) {
    Json table = table_json(path);
    line["columns"] = std::move(table["columns"]);
    line["cycles"].push_back({{"cycle", cycle}, {"rows", std::move(table["rows"])}});
  }
  line["reference"] = files.reference ? table_json(*files.reference) : Json();
  return line;
}

}  // namespace

Json profiles_json(const fs::path& folder) {
  if (!fs::is_directory(folder)) return Json::array();
  std::map<std::string, LineFiles> lines;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    add_file(lines, entry.path());
  Json profiles = Json::array();
  for (const auto& [name, files] : lines)
    if (!files.cycles.empty()) profiles.push_back(line_json(name, files));
  return profiles;
}

}  // namespace anisofront
