#include "drivers/base/console.hpp"

#include <regex>
#include <sstream>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

/// What a console with these settings writes when everything is said to it.
struct Said {
  std::string out, err;
};

Said all_said(Verbosity verbosity, LogFormat format, const std::string& text) {
  std::ostringstream out, err;
  Console console(out, err);
  console.set_verbosity(verbosity);
  console.set_log_format(format);
  console.say("say");
  console.print("print");
  console.detail("detail");
  console.warn(text);
  console.error(text);
  console.event("cycle", text, {{"variant", text}, {"cycle", 3}});
  console.progress({0.5, 10., "work"});
  console.end_progress();
  return {out.str(), err.str()};
}

std::vector<Json> lines_of(const std::string& text) {
  std::vector<Json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(Json::parse(line));
  return lines;
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("text logs are lines with their level and neither events nor a bar") {
  const Said normal = all_said(Verbosity::normal, LogFormat::text, "x");
  CHECK(normal.out == "say\nprint\n");
  CHECK(normal.err == "warning: x\nerror: x\n");
  const Said quiet = all_said(Verbosity::quiet, LogFormat::text, "x");
  CHECK(quiet.out == "print\n");
  CHECK(quiet.err == "error: x\n");
  CHECK(all_said(Verbosity::verbose, LogFormat::text, "x").out == "say\nprint\ndetail\n");
}

TEST_CASE("json logs are one object a line whatever the texts hold") {
  std::string every_byte;
  for (int c = 1; c < 256; ++c) every_byte += static_cast<char>(c);
  const Said said = all_said(Verbosity::normal, LogFormat::json, every_byte);
  CHECK(said.out == "say\nprint\n");  // for people, as ever
  const std::vector<Json> lines = lines_of(said.err);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0]["level"] == "warning");
  CHECK(lines[1]["level"] == "error");
  CHECK(lines[2]["level"] == "info");
  CHECK(lines[2]["event"] == "cycle");
  CHECK(lines[2]["cycle"] == 3);
  for (const Json& line : lines) {
    const std::string message = line["message"], time = line["time"];
    CHECK(message.substr(0, 127) == every_byte.substr(0, 127));
    const std::regex utc(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z)");
    CHECK(std::regex_match(time, utc));
  }
}

TEST_CASE("quiet json logs hold errors and events") {
  const auto lines = lines_of(all_said(Verbosity::quiet, LogFormat::json, "x").err);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0]["level"] == "error");
  CHECK(lines[1]["event"] == "cycle");
}

TEST_SUITE_END();
