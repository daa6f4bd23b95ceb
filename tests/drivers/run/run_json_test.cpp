#include "drivers/run/run_json.hpp"

#include <doctest/doctest.h>

using namespace anisofront;

TEST_SUITE_BEGIN("unit");

TEST_CASE("a run is described with its date in universal time") {
  RunFacts facts{"anisofront run \"a b.toml\"", {}, 1.5, 3, 130};
  facts.started = std::chrono::system_clock::from_time_t(1'000'000'000);
  const Json json = run_json(facts);
  CHECK(json["program"] == "anisofront");
  CHECK_FALSE(json["version"].get<std::string>().empty());
  CHECK(json["command"] == "anisofront run \"a b.toml\"");
  CHECK(json["date"] == "2001-09-09T01:46:40Z");
  CHECK(json["seconds"] == 1.5);
  CHECK(json["threads"] == 3);
  CHECK(json["exit_code"] == 130);
  CHECK(json.size() == 7);
}

TEST_CASE("a command that is not known is null") {
  CHECK(run_json({})["command"].is_null());
  CHECK(run_json({})["date"] == "1970-01-01T00:00:00Z");
}

TEST_SUITE_END();
