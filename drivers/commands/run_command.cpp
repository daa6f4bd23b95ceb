#include <memory>

#include "drivers/commands/command_line.hpp"
#include "drivers/commands/commands.hpp"
#include "drivers/run/run_study.hpp"

namespace anisofront {
namespace {

struct RunArguments {
  std::string study;
  std::string directory;
  std::vector<std::string> overrides;
  int threads = 1;
  bool resume = false, fresh = false;
};

int run(const RunArguments& arguments, Console& console) {
  const StudyFile study = read_study_file(arguments.study, parse_overrides(arguments.overrides));
  RunOptions options;
  options.threads = arguments.threads;
  if (arguments.resume) options.earlier = EarlierResults::resume;
  if (arguments.fresh) options.earlier = EarlierResults::ignore;
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
  auto* resume = command->add_flag("--resume", arguments->resume,
                                   "Unfinished variants go on after their last complete cycle");
  command
      ->add_flag("--fresh", arguments->fresh,
                 "Run everything anew, also what is finished with the same settings")
      ->excludes(resume);
  add_verbosity(*command, console);
  command->footer(
      "A variant that an earlier run has finished in the same folder with the same settings is "
      "not\n"
      "run again.\nExample:\n  anisofront run data/studies/reaction-diffusion-layer.toml -o layer "
      "-j 2\n"
      "  anisofront run data/studies/reaction-diffusion-layer.toml -o layer -j 2 --resume\n"
      "  anisofront run data/studies/paper/example-2.toml --set mesh.preset=best");
  command->callback([arguments, &console, &exit_code] { exit_code = run(*arguments, console); });
}

}  // namespace anisofront
