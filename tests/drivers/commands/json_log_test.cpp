#include <sstream>

#include <doctest/doctest.h>

#include "tests/drivers/program_call.hpp"
#include "tests/drivers/result_folder.hpp"
#include "tests/drivers/working_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Every line of the log, each of which must be one object.
std::vector<Json> log_of(const Result& result) {
  std::vector<Json> lines;
  std::istringstream stream(result.err);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(Json::parse(line));
    for (const char* key : {"time", "level", "message"}) CHECK(lines.back()[key].is_string());
  }
  return lines;
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("a run tells programs its cycles and its end") {
  const WorkingFolder folder;
  folder.write("s.toml",
               std::string(kTinyStudy) + "[vary]\n\"mesh.preset\" = [\"best\", \"paper\"]\n");
  const Result run = call({"--log-format", "json", "run", "s.toml"});
  const auto log = log_of(run);
  const Json history = read_json("s-results/history.json");
  REQUIRE(log.size() == 7);  // 2 variants with cycles 0 to 2, the end
  for (std::size_t i = 0; i < 6; ++i) {
    const Json& variant = history["variants"][i / 3];
    const Json& cycle = variant["cycles"][i % 3];
    CHECK(log[i]["event"] == "cycle");
    CHECK(log[i]["level"] == "info");
    CHECK(log[i]["variant"] == variant["name"]);
    CHECK(log[i]["cycle"] == cycle["cycle"]);
    CHECK(log[i]["vertices"] == cycle["vertices"]);
    CHECK(log[i]["elements"] == cycle["elements"]);
    CHECK(log[i]["seconds"].get<double>() >= 0);
  }
  CHECK(log.back()["event"] == "finished");
  CHECK(log.back()["exit_code"] == 0);
  CHECK(log.back()["seconds"].get<double>() > 0);
  CHECK(has(run.out, "results in s-results"));  // for people, as ever
}

TEST_CASE("every command logs json before and after its name and also its mistakes") {
  const WorkingFolder folder;
  const std::vector<std::vector<std::string>> calls{{"run", "no.toml"},
                                                    {"solve", "no.toml"},
                                                    {"metric", "explain", "no.toml", "--at", "0,0"},
                                                    {"report", "no"},
                                                    {"mesh", "no.msh"},
                                                    {"check", "no.msh"},
                                                    {"convert", "a.xyz"},
                                                    {"help", "no"},
                                                    {"completion", "fish"},
                                                    {"new", "no/s"},
                                                    {"man", "no"},
                                                    {"nothing"},
                                                    {"run", "--no"},
                                                    {"run", "x.toml", "-j", "x"}};
  for (const auto& words : calls) {
    auto before = words, after = words;
    before.insert(before.begin(), "--log-format=json");
    after.insert(after.end(), {"--log-format", "json"});
    for (const auto& command : {before, after}) {
      const Result result = call(command);
      CHECK(result.code == 3);
      const auto log = log_of(result);
      REQUIRE_MESSAGE(log.size() == 2, words.front());
      CHECK(log[0]["level"] == "error");
      CHECK_FALSE(log[0].contains("event"));
      CHECK(log[1]["exit_code"] == 3);
    }
  }
}

TEST_CASE("names of files may hold any bytes in a json log") {
  const auto log = log_of(call({"check", "a\xff\"\n\t\x01.msh", "--log-format=json"}));
  REQUIRE(log.size() == 2);
  CHECK(has(log[0]["message"], "a\xef\xbf\xbd\"\n\t\x01.msh"));
}

TEST_CASE("help and text logs stay as they are") {
  CHECK(log_of(call({"run", "--help", "--log-format", "json"})).back()["exit_code"] == 0);
  CHECK(call({"--log-format", "text", "check", "no.msh"}).err.starts_with("error: "));
  const Result wrong = call({"--log-format", "jsno", "check", "no.msh"});
  CHECK(wrong.code == 3);
  CHECK(has(wrong.err, "did you mean \"json\"?"));
}

TEST_SUITE_END();
