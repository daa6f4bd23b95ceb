#include <memory>

#include "drivers/command_line.hpp"
#include "drivers/commands.hpp"
#include "drivers/run_study.hpp"

namespace anisofront {
namespace {

struct RunArguments {
  std::string study;
  std::string directory;
  std::vector<std::string> overrides;
  int threads = 1;
};

int run(const RunArguments& arguments, Console& console) {
  const StudyFile study = read_study_file(arguments.study, parse_overrides(arguments.overrides));
  RunOptions options;
  options.threads = arguments.threads;
  options.directory =
      arguments.directory.empty() ? study.path.stem().string() + "-results" : arguments.directory;
  return run_study(study, options, console);
}

}  // namespace

void add_run_command(CLI::App& app, Console& console, int& exit_code) {
  CLI::App* command = app.add_subcommand("run", "Every variant of a study, all cycles, report");
  auto arguments = std::make_shared<RunArguments>();
  command->add_option("STUDY", arguments->study, "Study file (.toml)")->required();
  command->add_option("-o,--output", arguments->directory,
                      "Folder for the results (default: name of the study + \"-results\")");
  add_overrides(*command, arguments->overrides);
  command->add_option("-j,--jobs", arguments->threads, "Variants computed side by side")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  add_verbosity(*command, console);
  command->footer(
      "Example:\n  anisofront run data/studies/reaction-diffusion-layer.toml -o layer -j 2\n"
      "  anisofront run data/studies/paper/example-2.toml --set mesh.preset=best");
  command->callback([arguments, &console, &exit_code] { exit_code = run(*arguments, console); });
}

}  // namespace anisofront
