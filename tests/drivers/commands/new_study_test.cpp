#include "drivers/commands/new_study.hpp"

#include <regex>
#include <sstream>

#include <doctest/doctest.h>

#include "drivers/commands/study_templates.hpp"
#include "drivers/study/study_file.hpp"
#include "tests/drivers/program_call.hpp"
#include "tests/drivers/working_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The study with one line that was a comment, and for a table all that follow.
std::string with_comment_used(std::vector<std::string> lines, std::size_t used) {
  const bool is_table = lines[used].starts_with("# [");
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool is_used = i == used || (is_table && i > used && lines[i].starts_with("# "));
    text += (is_used ? lines[i].substr(2) : lines[i]) + "\n";
  }
  return text;
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("every kind of new study runs as it is and names the next command") {
  const WorkingFolder folder;
  for (const StudyTemplate& kind : study_templates()) {
    const Result made = call({"new", "first-" + kind.kind, "--kind", kind.kind});
    CHECK(made.code == 0);
    const std::string file = "first-" + kind.kind + ".toml";
    CHECK(lines_of(made.out).back() == "next: anisofront run " + file);
    CHECK(lines_of(made.out).front() == "wrote " + file);
    const Result run = call({"run", file, "-j", "2"});
    CHECK_MESSAGE(run.code == 0, run.err);
    CHECK(run.err.empty());
    CHECK(fs::exists("first-" + kind.kind + "-results/report.html"));
  }
}

TEST_CASE("whatever the comments of a new study offer is a valid study") {
  const WorkingFolder folder;
  const std::regex offer(R"(# ([\w.-]+|"[\w.-]+") = .*|# \[[\w.]+\])");
  for (const StudyTemplate& kind : study_templates()) {
    call({"new", "s", "--kind", kind.kind});
    const auto lines = lines_of(read_text_file("s.toml"));
    int offers = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!std::regex_match(lines[i], offer)) continue;
      if (lines[i].starts_with("# \"")) continue;  // belongs to the table above
      folder.write("used.toml", with_comment_used(lines, i));
      CHECK_MESSAGE(message_of<Error>([] { read_study_file("used.toml"); }) == "", lines[i]);
      ++offers;
    }
    CHECK(offers >= 3);
    fs::remove("s.toml");
    fs::remove("s.msh");
  }
}

TEST_CASE("the kind is that of the name where there is one") {
  const WorkingFolder folder;
  CHECK(call({"new", "plate"}).code == 0);
  CHECK(has(read_text_file("plate.toml"), "kind = \"mindlin\""));
  CHECK(call({"new", "anything.toml"}).code == 0);
  CHECK(read_text_file("anything.toml") == study_templates().front().text);
  CHECK(call({"new", "mesh"}).code == 0);
  CHECK(has(read_text_file("mesh.toml"), "mesh = \"mesh.msh\""));
}

TEST_CASE("files are never overwritten") {
  const WorkingFolder folder;
  folder.write("a.toml", "mine");
  const Result study = call({"new", "a"});
  CHECK(study.code == 3);
  CHECK(has(study.err, "a.toml: exists and is not overwritten"));
  CHECK(read_text_file("a.toml") == "mine");
  folder.write("b.msh", "mine too");
  CHECK(call({"new", "b", "--kind", "mesh"}).code == 3);
  CHECK(read_text_file("b.msh") == "mine too");
  CHECK_FALSE(fs::exists("b.toml"));
}

TEST_CASE("names of new studies may be any that files have") {
  const WorkingFolder folder;
  const std::string odd = "it's \"5\" \\ \xc3\xa9";
  const Result made = call({"new", odd, "--kind", "mesh"});
  CHECK(made.code == 0);
  CHECK(read_study_file(odd + ".toml").variants.front().study.domain_mesh.filename() ==
        odd + ".msh");
  CHECK(has(made.out, "next: anisofront run 'it'\\''s"));
  CHECK(call({"new", ""}).code == 3);
  CHECK(call({"new", "sub/"}).code == 3);
  CHECK(has(call({"new", "nowhere/s"}).err, "nowhere: no such folder"));
  CHECK(call({"new", "s", "--kind", "plaet"}).code == 3);
}

TEST_SUITE_END();
