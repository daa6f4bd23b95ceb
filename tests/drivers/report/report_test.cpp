#include "drivers/report/report.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/drivers/program_call.hpp"
#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

namespace fs = std::filesystem;

/// Runs the tiny study into FOLDER/NAME.
fs::path tiny_results(const TemporaryFolder& folder, const std::string& name) {
  const fs::path study = folder.write("tiny.toml", kTinyStudy);
  const fs::path results = folder.path() / name;
  fs::create_directories(results);
  REQUIRE(call({"run", study.string(), "-o", results.string(), "-q"}).code == 0);
  return results;
}

/// The data that a page holds.
Json data_of(const fs::path& page) {
  const std::string text = read_text_file(page);
  const std::string start = "id=\"report-data\">";
  const std::size_t begin = text.find(start) + start.size();
  return Json::parse(text.substr(begin, text.find("</script>", begin) - begin));
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("the page of a run holds its history files and meshes") {
  const TemporaryFolder folder;
  const fs::path results = tiny_results(folder, "results");
  const Json run = data_of(results / "report.html")["runs"][0];
  CHECK(run["name"] == "results");
  CHECK(run["csv"]["history.csv"] == read_text_file(results / "history.csv"));
  CHECK(run["study"] == read_text_file(results / "study.toml"));
  const Json& variant = run["variants"][0];
  CHECK(variant["cycles"] == read_json(results / "history.json")["variants"][0]["cycles"]);
  REQUIRE(variant["meshes"].size() == 3);
  const std::string id = variant["meshes"][2]["id"];
  CHECK(id == "mesh-0-0-2");
  CHECK(has(read_text_file(results / "report.html"), "id=\"" + id + "\">H4sI"));
}

TEST_CASE("the page again is the same page") {
  const TemporaryFolder folder;
  const fs::path results = tiny_results(folder, "results");
  const std::string before = read_text_file(results / "report.html");
  CHECK(call({"report", results.string()}).code == 0);
  CHECK(read_text_file(results / "report.html") == before);
}

TEST_CASE("a page of several runs calls them by as much of their paths as tells them apart") {
  const TemporaryFolder folder;
  const fs::path one = tiny_results(folder, "one/results");
  const fs::path two = tiny_results(folder, "two/results");
  const fs::path page = folder.path() / "both.html";
  const Result result = call({"report", one.string(), two.string() + "/", "-o", page.string()});
  CHECK(result.code == 0);
  CHECK(has(result.out, page.string()));
  const Json runs = data_of(page)["runs"];
  REQUIRE(runs.size() == 2);
  CHECK(runs[0]["name"] == "one/results");
  CHECK(runs[1]["name"] == "two/results");
  CHECK(runs[1]["folder"] == "two/results");
  CHECK(runs[1]["variants"][0]["meshes"][0]["id"] == "mesh-1-0-0");
}

TEST_CASE("folders that are no results or named twice are refused with what to do") {
  const TemporaryFolder folder;
  const fs::path results = tiny_results(folder, "results");
  const std::string missing =
      message_of<UsageError>([&] { make_report(folder.path() / "nothing"); });
  CHECK(has(missing, "history.json"));
  CHECK(has(missing, "anisofront run"));
  const std::string twice = message_of<UsageError>([&] {
    make_common_report({results, results / "."}, folder.path() / "both.html");
  });
  CHECK(has(twice, "named twice"));
  CHECK(call({"report"}).code == 3);
}
