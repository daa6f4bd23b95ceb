#include "drivers/report/history_file.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/drivers/report/page_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// What the program says of a folder with this history.json.
std::string refusal(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("history.json", text);
  return message_of<InputError>([&] { read_history_file(folder.path()); });
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("a history is read as it was written") {
  const TemporaryFolder folder;
  const Json history = history_json("t", {plain_variant("a", 2), plain_variant("b", 0)});
  folder.write("history.json", history.dump());
  CHECK(read_history_file(folder.path()) == history);
}

TEST_CASE("what later versions added may be missing") {
  const TemporaryFolder folder;
  Json history = history_json("t", {plain_variant("a", 1)});
  for (const char* key : {"version", "comparison"}) history.erase(key);
  Json& cycle = history["variants"][0]["cycles"][0];
  for (const char* key : {"angle", "stretch_max"}) cycle.erase(key);
  cycle["quality"].erase("histogram");
  folder.write("history.json", history.dump());
  CHECK(read_history_file(folder.path())["comparison"] == Json::array());
}

TEST_CASE("a folder without a history says what to give") {
  const TemporaryFolder folder;
  const std::string message = message_of<UsageError>([&] { read_history_file(folder.path()); });
  CHECK(has(message, "history.json"));
  CHECK(has(message, "anisofront run"));
}

TEST_CASE("a damaged history is refused with the file and what is missing") {
  CHECK(has(refusal("{"), "history.json"));
  CHECK(has(refusal("[]"), "schema 1"));
  CHECK(has(refusal(R"({"schema":2})"), "schema 1"));
  CHECK(has(refusal(R"({"schema":1})"), "a title"));
  CHECK(has(refusal(R"({"schema":1,"title":"t"})"), "variants"));
  CHECK(has(refusal(R"({"schema":1,"title":"t","variants":[3]})"), "name"));
}

TEST_CASE("no part of a cycle that reports read may be missing") {
  const Json whole = history_json("t", {plain_variant("a", 1)});
  for (const char* pointer :
       {"/name", "/cycles/0/dofs", "/cycles/0/error/estimate", "/cycles/0/background/quality/mean",
        "/cycles/0/edge_length/histogram/counts", "/cycles/0/warnings", "/cycles/0/values"}) {
    const Json::json_pointer place(pointer);
    Json history = whole;
    history["variants"][0][place.parent_pointer()].erase(place.back());
    CHECK_MESSAGE(has(refusal(history.dump()), "history.json"), pointer);
  }
}
