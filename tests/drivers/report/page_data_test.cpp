#include "drivers/report/page_data.hpp"

#include <doctest/doctest.h>

#include "tests/drivers/report/page_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

namespace fs = std::filesystem;

Json small_history() { return history_json("Title", {plain_variant("a", 2)}); }

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("old results have no program and no lines and still make data") {
  const TemporaryFolder folder;
  const Json data = run_data({"old", folder.path(), small_history()}, folder.path());
  CHECK(data["name"] == "old");
  CHECK(data["title"] == "Title");
  CHECK(data["folder"] == ".");
  for (const char* key : {"command", "date", "version", "problem"}) CHECK(data[key].is_null());
  CHECK(data["seconds"]["wall"].is_null());
  CHECK(data["study"] == "");
  CHECK(data["vary"] == Json::object());
  CHECK(data["csv"] == Json::object());
  CHECK(data["figures"] == Json::array());
  CHECK(data["comparison"] == Json::array());
  CHECK(data["variants"][0]["profiles"] == Json::array());
  CHECK(data["variants"][0]["cycles"] == small_history()["variants"][0]["cycles"]);
}

TEST_CASE("files of a run are taken as they are") {
  const TemporaryFolder folder;
  const std::string csv = "variant,cycle\r\n\"a \"\"b\"\" <c>\",0\n";
  folder.write("history.csv", csv);
  folder.write("run.json", R"({"program":"anisofront","command":"run x","seconds":1.5})");
  const std::string study =
      "[problem]\nkind = 'mindlin'\n[mesh]\ninterpolation = 'log-euclidean'\n"
      "[vary]\n\"problem.constants.t\" = [0.1, 0.01]\n[vary.supports]\nsoft = { a.b = 'c' }\n";
  folder.write("study.toml", study);
  const Json data = run_data({"run", folder.path(), small_history()}, folder.path());
  CHECK(data["csv"] == Json{{"history.csv", csv}});
  CHECK(data["command"] == "run x");
  CHECK(data["seconds"]["wall"] == 1.5);
  CHECK(data["study"] == study);
  CHECK(data["problem"] == "mindlin");
  CHECK(data["interpolation"] == "log-euclidean");
  CHECK(data["vary"]["problem.constants.t"] == Json{0.1, 0.01});
  CHECK(data["vary"]["supports"]["soft"]["a"]["b"] == "c");
}

TEST_CASE("a problem without a kind is the scalar one and a metric alone is none") {
  const TemporaryFolder folder;
  const auto problem = [&](const char* study) {
    folder.write("study.toml", study);
    return run_data({"run", folder.path(), small_history()}, folder.path())["problem"];
  };
  CHECK(problem("[problem]\nsource = 1\n") == "poisson");
  CHECK(problem("[metric]\nprescribed = []\n").is_null());
}

TEST_CASE("a damaged study or run file leaves only what depends on it empty") {
  const TemporaryFolder folder;
  folder.write("study.toml", "[problem\nkind");
  folder.write("run.json", "[1, 2");
  const Json data = run_data({"run", folder.path(), small_history()}, folder.path());
  CHECK(data["study"] == "[problem\nkind");
  CHECK(data["problem"].is_null());
  CHECK(data["command"].is_null());
}

TEST_CASE("drawings are listed in order and without their data") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "figures");
  for (const char* name : {"b.svg", "a.pdf", "a.png", "a.dat", "a.gp"})
    folder.write(std::string("figures/") + name, "x");
  const Json data = run_data({"run", folder.path(), small_history()}, folder.path().parent_path());
  CHECK(data["figures"] == Json{"a.pdf", "a.png", "b.svg"});
  CHECK(data["folder"] == folder.path().filename().string());
}

TEST_CASE("a variant that names a row of the paper has it beside") {
  VariantHistory variant = plain_variant("a", 1);
  variant.settings = {{"report.paper", "13e"}};
  const TemporaryFolder folder;
  const Json history = history_json("t", {variant});
  const Json row = run_data({"run", folder.path(), history}, folder.path())["variants"][0]["paper"];
  CHECK(row["name"] == "13e");
  CHECK(row["vertices"] == 471);
  // Euler: every inner edge belongs to two quadrilaterals.
  CHECK(row["boundary_edges"] == 2 * 892 - 4 * 422);
}
