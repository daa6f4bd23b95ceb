#pragma once

#include <filesystem>
#include <set>
#include <sstream>

#include "drivers/base/text.hpp"
#include "drivers/history/history_json.hpp"
#include "tests/drivers/problem_studies.hpp"

namespace anisofront::testing {

/// -Lap u = 1 on the unit square, u = 0 around it, in a few milliseconds a cycle.
inline std::string small_problem(const std::string& adapt, const std::string& rest = "") {
  return square_study(
      "kind = \"poisson\"\nsource = 1\nboundary.bottom = { value = 0 }\n"
      "boundary.right = { value = 0 }\nboundary.top = { value = 0 }\nboundary.left = { value = 0 }",
      "[adapt]\n" + adapt + "\n" + rest);
}

/// A history or a record without times.
inline Json timeless(Json json) {
  if (json.is_object()) json.erase("seconds");
  if (json.is_structured())
    for (Json& part : json) part = timeless(part);
  return json;
}

/// A table without the columns of times.
inline std::string timeless_csv(const std::string& csv) {
  std::istringstream lines(csv);
  std::set<std::size_t> times;
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::size_t column = 0;
    for (std::string field; std::getline(fields, field, ','); ++column) {
      if (field.starts_with("seconds_")) times.insert(column);
      if (times.count(column) == 0) text += field + ",";
    }
    text += "\n";
  }
  return text;
}

/// A page without times and how it was made.
inline std::string timeless_page(const std::string& page) {
  const std::string tag = "id=\"report-data\">";
  const std::size_t begin = page.find(tag) + tag.size();
  const std::size_t end = page.find("</script>", begin);
  Json data = timeless(Json::parse(page.substr(begin, end - begin)));
  for (Json& run : data["runs"]) {
    for (const char* key : {"command", "date"}) run.erase(key);
    for (Json& table : run["csv"]) table = timeless_csv(table.get<std::string>());
  }
  return page.substr(0, begin) + data.dump() + page.substr(end);
}

/// What a file says, times left out.
inline std::string timeless_content(const std::filesystem::path& path) {
  const std::string content = read_text_file(path);
  if (path.extension() == ".json") return timeless(Json::parse(content)).dump();
  if (path.extension() == ".html") return timeless_page(content);
  return path.extension() == ".csv" ? timeless_csv(content) : content;
}

/// Names of all files below a folder.
inline std::set<std::string> files_below(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      names.insert(std::filesystem::relative(entry.path(), folder).string());
  return names;
}

/// Files that say how and how fast something ran: run.json and the figure of the timings.
inline bool is_about_run(const std::string& name) {
  return name == "run.json" || name.starts_with("figures/timings.");
}

/// The files that are missing in one of the folders or say something else, times left out.
inline std::string differences(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::string text;
  std::set<std::string> names = files_below(a);
  names.merge(files_below(b));
  for (const std::string& name : names)
    if (!is_about_run(name) &&
        (!std::filesystem::exists(a / name) || !std::filesystem::exists(b / name) ||
         timeless_content(a / name) != timeless_content(b / name)))
      text += name + "\n";
  return text;
}

}  // namespace anisofront::testing
