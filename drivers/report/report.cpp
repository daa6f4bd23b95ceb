#include "drivers/report/report.hpp"

#include <algorithm>
#include <set>

#include "drivers/base/text.hpp"
#include "drivers/report/figures.hpp"
#include "drivers/report/history_file.hpp"
#include "drivers/report/page.hpp"
#include "drivers/report/page_data.hpp"
#include "drivers/report/page_meshes.hpp"
#include "drivers/report/result_tables.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxPageBytes = 15'000'000;
constexpr std::size_t kMaxMeshBytes = 12'000'000;

/// The last `depth` parts of a path.
std::string tail(const fs::path& path, int depth) {
  std::string text;
  auto part = path.end();
  for (int i = 0; i < depth && part != path.begin(); ++i) {
    --part;
    text = i == 0 ? part->string() : part->string() + "/" + text;
  }
  return text;
}

/// Names of the folders, with as many of those above them as tell one from the other.
std::vector<std::string> unique_names(const std::vector<fs::path>& directories) {
  std::vector<fs::path> paths;
  for (const fs::path& directory : directories) {
    paths.push_back(fs::weakly_canonical(directory));
    if (!paths.back().has_filename()) paths.back() = paths.back().parent_path();
    if (std::count(paths.begin(), paths.end(), paths.back()) > 1)
      throw UsageError(directory.string() + ": this folder is named twice");
  }
  for (int depth = 1;; ++depth) {
    std::vector<std::string> names;
    for (const fs::path& path : paths) names.push_back(tail(path, depth));
    if (std::set(names.begin(), names.end()).size() == names.size()) return names;
  }
}

void add_tables(std::vector<TextTable>& tables, const Json& history) {
  for (TextTable table : {summary_table(history), comparison_table(history), value_table(history)})
    if (!table.rows.empty()) tables.push_back(std::move(table));
}

std::string common_title(const std::vector<ReportRun>& runs) {
  std::set<std::string> titles;
  std::vector<std::string> names;
  for (const ReportRun& run : runs) {
    titles.insert(run.history["title"]);
    names.push_back(run.name);
  }
  return titles.size() == 1 ? *titles.begin() : joined(names, " and ");
}

void write_page(const std::vector<ReportRun>& runs, const fs::path& page) {
  const fs::path folder = fs::absolute(page).parent_path();
  PageContent content{common_title(runs), {}, {}, {}};
  content.data = {{"version", ANISOFRONT_VERSION}, {"runs", Json::array()}};
  std::vector<fs::path> folders;
  for (const ReportRun& run : runs) {
    content.data["runs"].push_back(run_data(run, folder));
    add_tables(content.tables, run.history);
    folders.push_back(run.directory);
  }
  const std::size_t size = page_html(content).size();
  const std::size_t left = kMaxPageBytes - std::min(size, kMaxPageBytes);
  content.meshes = add_meshes(content.data["runs"], folders, std::min(left, kMaxMeshBytes));
  write_text_file(page, page_html(content));
}

std::vector<ReportRun> read_runs(const std::vector<fs::path>& directories) {
  const std::vector<std::string> names = unique_names(directories);
  std::vector<ReportRun> runs;
  for (std::size_t i = 0; i < directories.size(); ++i)
    runs.push_back({names[i], directories[i], read_history_file(directories[i])});
  return runs;
}

}  // namespace

std::vector<std::string> make_report(const fs::path& directory) {
  const std::vector<ReportRun> runs = read_runs({directory});
  const FigureList list = draw_figures(runs.front().history, directory);
  write_page(runs, directory / "report.html");
  return list.problems;
}

void make_common_report(const std::vector<fs::path>& directories, const fs::path& page) {
  write_page(read_runs(directories), page);
}

}  // namespace anisofront
