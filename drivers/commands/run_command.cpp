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

int run(const RunArguments& arguments, const Session& session) {
  const StudyFile study = read_study_file(arguments.study, parse_overrides(arguments.overrides));
  RunOptions options;
  options.command = session.command_line;
  options.threads = arguments.threads;
  if (arguments.resume) options.earlier = EarlierResults::resume;
  if (arguments.fresh) options.earlier = EarlierResults::ignore;
  options.directory =
      arguments.directory.empty() ? study.path.stem().string() + "-results" : arguments.directory;
  return run_study(study, options, session.console);
}

}  // namespace

void add_run_command(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand("run", "Every variant of a study, all cycles, report");
  auto arguments = std::make_shared<RunArguments>();
  command->add_option("STUDY", arguments->study, "Study file (.toml)")
      ->required()
      ->check(file_name({".toml"}));
  command
      ->add_option("-o,--output", arguments->directory,
                   "Folder for the results (default: name of the study + \"-results\")")
      ->type_name("DIR");
  add_overrides(*command, arguments->overrides);
  command->add_option("-j,--jobs", arguments->threads, "Variants computed side by side")
      ->type_name("N")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  auto* resume = command->add_flag("--resume", arguments->resume,
                                   "Unfinished variants go on after their last complete cycle");
  command
      ->add_flag("--fresh", arguments->fresh,
                 "Run everything anew, also what is finished with the same settings")
      ->excludes(resume);
  add_verbosity(*command, session.console);
  command->footer(
      "Leaves the page report.html, figures, history.json, history.csv and the meshes of every "
      "cycle in the folder. A variant that an earlier run has finished there with the same "
      "settings is not run again.\n\nExamples:\n"
      "  anisofront run layer.toml\n"
      "  anisofront run layer.toml -o quick -j 2 --set adapt.cycles=2 --set problem.order=2\n"
      "  anisofront run layer.toml --resume");
  command->callback([arguments, &session] { session.exit_code = run(*arguments, session); });
}

}  // namespace anisofront
