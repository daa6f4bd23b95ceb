#include "drivers/commands/program.hpp"

#include <CLI/CLI.hpp>

#include "drivers/base/console.hpp"
#include "drivers/base/interrupt.hpp"
#include "drivers/base/text.hpp"
#include "drivers/commands/commands.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

constexpr int kUsage = static_cast<int>(ErrorKind::usage);

/// "--metric" and "-o" of a command, names of its subcommands.
std::vector<std::string> known_words(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    for (const std::string& name : option->get_snames()) words.push_back("-" + name);
  }
  for (const CLI::App* command : app.get_subcommands({})) words.push_back(command->get_name());
  return words;
}

/// The innermost command that was given: `explain` of `metric explain`.
const CLI::App& used_command(const CLI::App& app) {
  const auto used = app.get_subcommands();
  return used.empty() ? app : used_command(*used.front());
}

/// "anisofront metric explain".
std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : full_name(*parent) + " " + command.get_name();
}

/// CLI11's message, and for words it does not know the nearest one.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = used_command(app);
  std::string message = error.what();
  for (const std::string& word : app.remaining(true)) {
    const std::string name = word.substr(0, word.find('='));
    return "unknown argument \"" + name + "\"" + name_proposal(name, known_words(command));
  }
  return message + " (" + full_name(command) + " --help shows what is known)";
}

int parse_and_run(CLI::App& app, int argc, char** argv, std::ostream& out, Console& console,
                  const int& exit_code) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version, out, out);
  } catch (const CLI::ParseError& error) {
    console.error(usage_message(app, error));
    return kUsage;
  }
  return exit_code;
}

}  // namespace

int run_program(int argc, char** argv, std::ostream& out, std::ostream& err) {
  const InterruptGuard guard;
  Console console(out, err);
  int exit_code = 0;
  CLI::App app("Adaptive finite elements in 2D on anisotropic meshes", "anisofront");
  app.set_version_flag("--version", "anisofront " ANISOFRONT_VERSION);
  app.require_subcommand(1);
  add_run_command(app, console, exit_code);
  add_solve_command(app, console);
  add_mesh_command(app, console);
  add_check_command(app, console, exit_code);
  add_convert_command(app, console);
  add_metric_command(app, console);
  add_report_command(app, console);
  app.footer(
      "Exit codes: 0 done, 1 target missed, 2 failed, 3 usage or study file,\n"
      "4 invalid input, 5 budget reached, 130 interrupted.");
  try {
    return parse_and_run(app, argc, argv, out, console, exit_code);
  } catch (const Error& error) {
    console.error(error.what());
    return static_cast<int>(error.kind());
  } catch (const std::bad_alloc&) {
    console.error("out of memory; a coarser metric or --max-nodes needs less");
    return static_cast<int>(ErrorKind::budget);
  } catch (const std::exception& error) {
    console.error(std::string("unexpected failure, please report it: ") + error.what());
    return static_cast<int>(ErrorKind::failed);
  }
}

}  // namespace anisofront
