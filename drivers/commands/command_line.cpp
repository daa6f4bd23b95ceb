#include "drivers/commands/command_line.hpp"

#include <algorithm>

#include <unistd.h>

#include "drivers/base/terminal.hpp"
#include "drivers/base/text.hpp"
#include "drivers/commands/command_tree.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {

std::string help_of(const CLI::App& command) {
  constexpr int kWidest = 100;
  return help_text(describe(command), std::min(kWidest, terminal_columns(STDOUT_FILENO, kWidest)));
}

void set_help_style(CLI::App& app) {
  app.formatter_fn([](const CLI::App* command, const std::string&, CLI::AppFormatMode) {
    return help_of(*command);
  });
  app.set_help_flag("-h,--help", "This text");
}

void add_verbosity(CLI::App& command, Console& console) {
  auto* quiet = command.add_flag_callback(
      "-q,--quiet", [&console] { console.set_verbosity(Verbosity::quiet); },
      "Only errors and what was asked for");
  auto* verbose = command.add_flag_callback(
      "-v,--verbose", [&console] { console.set_verbosity(Verbosity::verbose); },
      "Details and times");
  quiet->excludes(verbose)->group(kGeneralGroup);
  verbose->group(kGeneralGroup);
  // Read by asked_log_format() before anything else.
  command
      .add_option_function<std::string>(
          "--log-format", [](const std::string&) {},
          "Lines on stderr: for people, or one JSON object each for programs")
      ->type_name("WORD")
      ->check(one_of({"text", "json"}))
      ->group(kGeneralGroup);
}

void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
  // One value per --set, so that the study file may follow it.
  command
      .add_option("--set", overrides,
                  "In place of what the study says, such as adapt.cycles=3; any number of times")
      ->take_all()
      ->expected(1)
      ->type_name("KEY=VALUE");
}

void add_output_format(CLI::App& command, OutputFormat& format) {
  command.add_option("--format", format.version, "Version of .msh files")
      ->type_name("WORD")
      ->check(one_of({"4.1", "2.2"}))
      ->capture_default_str()
      ->group("Output");
  command.add_flag("--binary", format.binary, "Binary .msh files")->group("Output");
}

GmshFormat gmsh_format(const OutputFormat& format) {
  return {format.version == "2.2" ? GmshVersion::v2_2 : GmshVersion::v4_1, format.binary};
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto complaint = [words](const std::string& word) -> std::string {
    if (std::find(words.begin(), words.end(), word) != words.end()) return {};
    const bool is_near = !nearest_name(word, words).empty();
    return "found \"" + word + "\", expected one of: " + joined(words) +
           (is_near ? name_proposal(word, words) : "");
  };
  return {complaint, joined(words, "|")};
}

CLI::Validator file_name(const std::vector<std::string>& suffixes) {
  return {[](const std::string&) { return std::string(); }, joined(suffixes, "|")};
}

void require_writable_mesh(const std::filesystem::path& path) {
  const std::vector<std::string> known{".msh", ".mesh", ".vtu", ".svg"};
  const std::string suffix = path.extension().string();
  if (std::find(known.begin(), known.end(), suffix) == known.end())
    throw UsageError(path.string() + ": unknown mesh format \"" + suffix +
                     "\"; known: " + joined(known));
  const auto folder = path.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder))
    throw UsageError(folder.string() + ": no such folder (for " + path.string() + ")");
}

}  // namespace anisofront
