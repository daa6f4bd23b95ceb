#include <memory>

#include "drivers/commands/command_line.hpp"
#include "drivers/commands/commands.hpp"
#include "drivers/run/solve_study.hpp"

namespace anisofront {
namespace {

struct SolveArguments {
  std::string study;
  std::string directory;
  std::vector<std::string> overrides;
};

void solve(const SolveArguments& arguments, Console& console) {
  const StudyFile study = read_study_file(arguments.study, parse_overrides(arguments.overrides));
  solve_study(
      study,
      arguments.directory.empty() ? study.path.stem().string() + "-solution" : arguments.directory,
      console);
}

}  // namespace

void add_solve_command(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand("solve", "One solve on the initial mesh of a study");
  auto arguments = std::make_shared<SolveArguments>();
  command->add_option("STUDY", arguments->study, "Study file (.toml) with a [problem]")
      ->required()
      ->check(file_name({".toml"}));
  command
      ->add_option("-o,--output", arguments->directory,
                   "Folder for the results (default: name of the study + \"-solution\")")
      ->type_name("DIR");
  add_overrides(*command, arguments->overrides);
  add_verbosity(*command, session.console);
  command->footer(
      "Writes solution.json, solution.msh, solution.vtu and lines/NAME.csv; with [vary] each "
      "variant has a folder of its own.\n\nExamples:\n"
      "  anisofront solve floor.toml\n"
      "  anisofront solve floor.toml -o quads --set mesh.elements=quadrilateral");
  command->callback([arguments, &session] { solve(*arguments, session.console); });
}

}  // namespace anisofront
