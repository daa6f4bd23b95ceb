#include "drivers/commands/completion.hpp"

#include <set>
#include <sstream>

#include <doctest/doctest.h>

#include "tests/drivers/program_call.hpp"
#include "tests/drivers/shell_output.hpp"
#include "tests/drivers/working_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Loads the script as ~/.bashrc does, then completes the words as bash does at TAB.
constexpr const char* kBash = R"(source ./script
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
_anisofront
printf '%s\n' "${COMPREPLY[@]}"
)";

/// What bash proposes for the last of the words.
std::set<std::string> proposals(const std::string& words) {
  std::istringstream lines(shell_output("bash ./complete anisofront " + words));
  std::set<std::string> found;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) found.insert(line);
  return found;
}

using Set = std::set<std::string>;

void write_files(const WorkingFolder& folder) {
  for (const char* name : {"a.toml", "b c.toml", "m.msh", "m.mesh", "m.sol", "m.vtu", "x.txt"})
    folder.write(name, "");
  std::filesystem::create_directory("results");
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("bash completes commands and options and their words") {
  const WorkingFolder folder;
  write_files(folder);
  folder.write("complete", kBash);
  folder.write("script", call({"completion", "bash"}).out);
  CHECK(proposals("\"\"") == Set{"new", "run", "solve", "metric", "report", "mesh", "check",
                                 "convert", "help", "completion"});
  CHECK(proposals("r") == Set{"run", "report"});
  CHECK(proposals("-q --log-format json r") == Set{"run", "report"});
  CHECK(proposals("metric ex") == Set{"explain"});
  CHECK(proposals("run --re") == Set{"--resume"});
  CHECK(proposals("metric explain --v") == Set{"--variant", "--verbose"});
  CHECK(proposals("mesh a.toml --quad-start r") == Set{"right-angle"});
  CHECK(proposals("mesh a.toml --preset = \"\"") == Set{"best", "paper"});
  CHECK(proposals("mesh a.toml --preset =") == Set{"best", "paper"});
  CHECK(proposals("mesh a.toml --preset = paper --format 2") == Set{"2.2"});
  CHECK(proposals("completion z") == Set{"zsh"});
  CHECK(proposals("new s --kind p") == Set{"plate", "paper"});
  CHECK(proposals("help co") == Set{"convert", "completion"});
}

TEST_CASE("bash completes files by what a command reads") {
  const WorkingFolder folder;
  write_files(folder);
  folder.write("complete", kBash);
  folder.write("script", call({"completion", "bash"}).out);
  CHECK(proposals("run \"\"") == Set{"a.toml", "b c.toml", "results"});
  CHECK(proposals("run b") == Set{"b c.toml"});
  CHECK(proposals("run a.toml -o \"\"") == Set{"results"});
  CHECK(proposals("run -o results \"\"") == Set{"a.toml", "b c.toml", "results"});
  CHECK(proposals("check m") == Set{"m.msh", "m.mesh"});
  CHECK(proposals("check m.msh --metric m") == Set{"m.msh", "m.sol"});
  CHECK(proposals("convert m.msh m") == Set{"m.msh", "m.mesh", "m.vtu"});
  CHECK(proposals("report \"\"") == Set{"results"});
  CHECK(proposals("run a.toml --jobs \"\"").empty());
}

TEST_CASE("the script for zsh is valid and knows all commands") {
  const WorkingFolder folder;
  const std::string script = call({"completion", "zsh"}).out;
  CHECK(call({"completion", "zsh", "-o", "_anisofront"}).out.empty());
  CHECK(read_text_file("_anisofront") == script);
  CHECK(script.starts_with("#compdef anisofront\n"));
  for (const char* part : {"_anisofront_metric_explain()", "'new:A commented study file",
                           "--preset=[", ":(best paper)'", ":DIR:_files -/'"})
    CHECK_MESSAGE(has(script, part), part);
  if (!is_installed("zsh")) {
    MESSAGE("zsh is not installed: its syntax is not checked");
    return;
  }
  CHECK(shell_output("zsh -n _anisofront") == "");
}

TEST_CASE("the scripts quote what shells would take for their own") {
  CommandHelp program;
  program.name = "anisofront";
  OptionHelp option;
  option.names = {"--odd"};
  option.text = "it's [a]: \"b\" $(c) `d` \\";
  option.value = {"A:B", {}, {}, false, false, false};
  program.options.push_back(option);
  program.commands.push_back({});
  program.commands.back().name = "anisofront it";
  program.commands.back().summary = "that's: it";
  const WorkingFolder folder;
  folder.write("script", bash_completion(program));
  CHECK(shell_output("bash -n script") == "");
  if (!is_installed("zsh")) return;
  folder.write("script", zsh_completion(program));
  CHECK(shell_output("zsh -n script") == "");
}

TEST_CASE("zsh completes on a terminal of its own") {
  if (!is_installed("zsh")) {
    MESSAGE("zsh is not installed: its completion is not checked");
    return;
  }
  const WorkingFolder folder;
  write_files(folder);
  std::filesystem::create_directory("functions");
  folder.write("functions/_anisofront", call({"completion", "zsh"}).out);
  // Types lines into a zsh on a pseudo-terminal; after each, what it must show within 30 seconds.
  folder.write("type", R"zsh(zmodload zsh/zpty
zpty -b z zsh -f -i
zpty -w z "PROMPT=; fpath=($PWD/functions \$fpath); autoload -Uz compinit; compinit -u -D"
zpty -w z "bindkey '^I' complete-word; print RE''ADY"
while zpty -r z line; do [[ $line == *READY* ]] && break; done
for typed expected; do
  zpty -w -n z "anisofront $typed"$'\t'
  shown=
  for ((wait = 0; wait < 300; wait++)); do
    while zpty -rt z line; do shown+=$line; done
    [[ $shown == *$expected* ]] && break
    sleep 0.1
  done
  [[ $shown == *$expected* ]] || print -r -- "$typed: no $expected in $shown"
  zpty -w -n z $'\x15'
done
zpty -d z
)zsh");
  CHECK(shell_output("zsh type comp completion 'run a' a.toml 'run --res' --resume"
                     " 'mesh a.toml --quad-start r' right-angle 'report res' results"
                     " 'metric explain --va' --variant 'help me' metric") == "");
}

TEST_SUITE_END();
