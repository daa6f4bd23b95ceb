#include "drivers/report/page_data.hpp"

#include <set>
#include <sstream>

#include <toml++/toml.h>

#include "drivers/base/text.hpp"
#include "drivers/report/page_profiles.hpp"
#include "drivers/study/paper_table.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

std::string text_or_nothing(const fs::path& path) {
  return fs::is_regular_file(path) ? read_text_file(path) : std::string();
}

/// Sets what run.json says about the run.
void add_program(Json& data, const fs::path& directory) {
  Json program = Json::parse(text_or_nothing(directory / "run.json"), nullptr, false);
  if (!program.is_object()) program = Json::object();
  for (const char* key : {"command", "date", "version"}) data[key] = program.value(key, Json());
  data["seconds"] = {{"wall", program.value("seconds", Json())},
                     {"threads", program.value("threads", Json())}};
}

Json csv_json(const fs::path& directory) {
  Json files = Json::object();
  for (const char* name : {"history.csv", "comparison.csv"})
    if (fs::is_regular_file(directory / name)) files[name] = read_text_file(directory / name);
  return files;
}

/// Names of the drawings in figures/, in order.
Json figure_names(const fs::path& folder) {
  std::set<std::string> names;
  if (fs::is_directory(folder))
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      for (const char* suffix : {".svg", ".png", ".pdf"})
        if (entry.path().extension() == suffix) names.insert(entry.path().filename().string());
  return names;
}

Json as_json(const toml::table& table) {
  std::ostringstream text;
  text << toml::json_formatter{table};
  const Json json = Json::parse(text.str(), nullptr, false);
  return json.is_object() ? json : Json::object();
}

/// Sets what the resolved study says about the problem and about what varies.
void add_study(Json& data, const std::string& study) {
  data["study"] = study;
  data["problem"] = nullptr;
  data["interpolation"] = nullptr;
  data["vary"] = Json::object();
  try {
    const toml::table root = toml::parse(study);
    if (root["problem"].is_table())
      data["problem"] = root["problem"]["kind"].value_or(std::string("poisson"));
    if (const auto name = root["mesh"]["interpolation"].value<std::string>())
      data["interpolation"] = *name;
    if (const toml::table* vary = root["vary"].as_table()) data["vary"] = as_json(*vary);
  } catch (const toml::parse_error&) {
    // The page shows the text all the same.
  }
}

Json paper_json(const PaperRow& row) {
  const int corners = has_quads(row) ? 4 : 3;
  return {{"name", row.name},
          {"vertices", row.vertices},
          {"elements", row.elements},
          {"edges", row.edges},
          {"boundary_edges", 2 * row.edges - corners * row.elements},
          {"quality_mean", row.quality_mean},
          {"quality_min", row.quality_min},
          {"percent_half", row.percent_half},
          {"length_min", row.length_min},
          {"length_max", row.length_max}};
}

Json variant_data(Json variant, const fs::path& directory) {
  const std::string row_name = variant["settings"].value("report.paper", std::string());
  if (const PaperRow* row = paper_row(row_name)) variant["paper"] = paper_json(*row);
  const fs::path lines = directory / variant["name"].get<std::string>() / "lines";
  variant["profiles"] = profiles_json(lines);
  return variant;
}

}  // namespace

Json run_data(const ReportRun& run, const fs::path& page_folder) {
  Json data{{"name", run.name},
            {"title", run.history["title"]},
            {"folder", fs::relative(run.directory, page_folder).generic_string()}};
  add_program(data, run.directory);
  add_study(data, text_or_nothing(run.directory / "study.toml"));
  data["figures"] = figure_names(run.directory / "figures");
  data["csv"] = csv_json(run.directory);
  data["variants"] = Json::array();
  for (const Json& variant : run.history["variants"])
    data["variants"].push_back(variant_data(variant, run.directory));
  data["comparison"] = run.history.value("comparison", Json::array());
  return data;
}

}  // namespace anisofront
