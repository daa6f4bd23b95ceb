#include <map>
#include <regex>
#include <sstream>

#include <doctest/doctest.h>

#include "tests/drivers/program_call.hpp"
#include "tests/drivers/working_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

Words words_of(const std::string& line) {
  std::istringstream stream(line);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

Words with(Words words, const std::string& last) {
  words.push_back(last);
  return words;
}

/// Lines below "Example:" or "Examples:" in a help text.
std::vector<std::string> examples_of(const std::string& help) {
  std::vector<std::string> examples;
  std::istringstream stream(help.substr(std::min(help.find("\nExample"), help.size())));
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("  anisofront ")) examples.push_back(line.substr(2));
  return examples;
}

/// Names of the subcommands that a help text lists: between the usage and the options.
Words listed_commands(const std::string& help) {
  Words names;
  const std::regex entry("  ([a-z]+)  +[A-Z].*");
  std::istringstream stream(help.substr(0, help.find("\nGeneral options:")));
  std::smatch match;
  for (std::string line; std::getline(stream, line);)
    if (std::regex_match(line, match, entry)) names.push_back(match[1]);
  return names;
}

/// The help texts of a command and all below it, in the order in which they are listed.
void collect_help(const Words& command, std::vector<std::pair<Words, std::string>>& texts) {
  const Result help = call(with(command, "--help"));
  REQUIRE(help.code == 0);
  texts.emplace_back(command, help.out);
  for (const std::string& name : listed_commands(help.out))
    collect_help(with(command, name), texts);
}

std::vector<std::pair<Words, std::string>> all_help() {
  std::vector<std::pair<Words, std::string>> texts;
  collect_help({}, texts);
  collect_help({"man"}, texts);  // is not listed
  return texts;
}

std::string value_after(const Words& words, const std::string& option) {
  const auto found = std::find(words.begin(), words.end(), option);
  return found == words.end() || found + 1 == words.end() ? "" : *(found + 1);
}

/// What is there after an example, by the words of its help.
std::vector<fs::path> promised_files(const Words& words) {
  const std::string& command = words.at(0);
  const std::string output = value_after(words, "-o");
  const std::string stem = words.size() > 1 ? fs::path(words[1]).stem().string() : "";
  if (command == "new") return {words[1] + ".toml"};
  if (command == "run") {
    const fs::path folder = output.empty() ? stem + "-results" : output;
    return {folder / "report.html", folder / "history.json", folder / "history.csv",
            folder / "study.toml"};
  }
  if (command == "solve") {
    const fs::path folder = output.empty() ? stem + "-solution" : output;
    return {folder / "solution.json", folder / "solution.msh", folder / "solution.vtu"};
  }
  if (command == "convert") return {words.at(2)};
  if (command == "man" && !output.empty()) return {fs::path(output) / "anisofront-run.1"};
  if (!output.empty()) return {output};
  return {};
}

/// Of the folders that a report takes for granted those that no earlier example has left.
void provide_results(const Words& words) {
  for (std::size_t i = 1; i < words.size() && !words[i].starts_with("-"); ++i)
    if (!fs::exists(words[i])) fs::copy("layer-results", words[i], fs::copy_options::recursive);
}

/// Runs an example as a shell would: what follows ">" is the name of a file.
Result run_example(const std::string& example) {
  const std::size_t arrow = example.find(" > ");
  Words words = words_of(example.substr(0, arrow));
  words.erase(words.begin());
  if (words[0] == "report") provide_results(words);
  Result result = call(words);
  for (const fs::path& file : promised_files(words)) CHECK_MESSAGE(fs::exists(file), file);
  if (words[0] == "metric" || words[0] == "check" || words[0] == "help" ||
      arrow != std::string::npos)
    CHECK(result.out.size() > 100);
  if (arrow != std::string::npos) std::ofstream(example.substr(arrow + 3)) << result.out;
  return result;
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("the examples of all help texts run one after the other") {
  const WorkingFolder folder;
  fs::create_directory_symlink(ANISOFRONT_DATA, "data");
  int count = 0;
  for (const auto& [command, help] : all_help()) {
    const auto examples = examples_of(help);
    CHECK_MESSAGE(!examples.empty(), help);
    for (const std::string& example : examples) {
      const Result result = run_example(example);
      CHECK_MESSAGE(result.code == 0, example, "\n", result.err);
      ++count;
    }
  }
  CHECK(count > 20);
}

TEST_CASE("every help text fits its columns and says what there is to say") {
  std::size_t commands = 0;
  for (const auto& [command, help] : all_help()) {
    ++commands;
    for (const char* part : {"Usage: anisofront", "General options:", "-q, --quiet",
                             "--log-format text|json", "Example", "Exit codes: 0 done; 1 done"})
      CHECK_MESSAGE(has(help, part), help);
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
      CHECK_MESSAGE(line.size() <= 100, line);
      CHECK_MESSAGE((line.empty() || line.back() != ' '), line);
    }
  }
  CHECK(commands == 13);  // the program, 11 commands, metric explain
}

TEST_CASE("help of a command is its own option and the program alone shows what there is") {
  CHECK(call({"help", "run"}).out == call({"run", "--help"}).out);
  CHECK(call({"help", "metric", "explain"}).out == call({"metric", "explain", "--help"}).out);
  CHECK(call({"help"}).out == call({"--help"}).out);
  const Result alone = call({});
  CHECK(alone.code == 3);
  CHECK(alone.out == call({"--help"}).out);
  CHECK(alone.err.empty());
  const Result group = call({"metric"});
  CHECK(group.code == 3);
  CHECK(group.out == call({"metric", "--help"}).out);
  const Result unknown = call({"help", "mehs"});
  CHECK(unknown.code == 3);
  CHECK(has(unknown.err, "did you mean \"mesh\"?"));
}

TEST_SUITE_END();
