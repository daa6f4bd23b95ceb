#include "drivers/commands/program.hpp"

#include <algorithm>
#include <chrono>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "drivers/base/interrupt.hpp"
#include "drivers/base/shell_words.hpp"
#include "drivers/base/text.hpp"
#include "drivers/commands/command_line.hpp"
#include "drivers/commands/command_tree.hpp"
#include "drivers/commands/commands.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

constexpr int kUsage = static_cast<int>(ErrorKind::usage);

/// The subcommands in the order of the help, each in its group; without a group it is not listed.
struct Subcommand {
  const char* group;
  void (*add)(CLI::App& app, Session& session);
};
constexpr Subcommand kSubcommands[] = {
    {"Studies", add_new_command},
    {"Studies", add_run_command},
    {"Studies", add_solve_command},
    {"Studies", add_metric_command},
    {"Studies", [](CLI::App& app, Session& session) { add_report_command(app, session.console); }},
    {"Meshes", add_mesh_command},
    {"Meshes", add_check_command},
    {"Meshes", add_convert_command},
    {"Help", add_help_command},
    {"Help", add_completion_command},
    {"", add_man_command},
};

/// Asked for before the command line is read, so that its mistakes are told in this format too.
LogFormat asked_log_format(const std::vector<std::string>& words) {
  LogFormat format = LogFormat::text;
  std::string last;
  for (const std::string& word : words) {
    const std::string pair = last == "--log-format" ? last + "=" + word : word;
    if (pair == "--log-format=json") format = LogFormat::json;
    if (pair == "--log-format=text") format = LogFormat::text;
    last = word;
  }
  return format;
}

/// The innermost command that was given: `explain` of `metric explain`.
const CLI::App& used_command(const CLI::App& app) {
  const auto used = app.get_subcommands();
  return used.empty() ? app : used_command(*used.front());
}

/// CLI11's "--output: 1 required DIR missing" in plain words.
std::string plain_message(const CLI::ParseError& error) {
  const std::string message = error.what();
  const std::size_t end = message.find(": 1 required ");
  return end == std::string::npos ? message : message.substr(0, end) + " needs a value";
}

/// CLI11's message, and for words it does not know the nearest one.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = used_command(app);
  for (const std::string& word : app.remaining(true)) {
    const std::string name = word.substr(0, word.find('='));
    return "unknown argument \"" + name + "\"" + name_proposal(name, known_words(command));
  }
  return plain_message(error) + " (" + full_name(command) + " --help shows what is known)";
}

int parse_and_run(CLI::App& app, std::vector<std::string> words, std::ostream& out,
                  Session& session) {
  try {
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    app.parse(std::move(words));
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version, out, out);
  } catch (const CLI::ParseError& error) {
    const CLI::App& command = used_command(app);
    const bool is_incomplete = error.get_name() == "RequiredError" &&
                               !command.get_subcommands({}).empty() && app.remaining(true).empty();
    if (is_incomplete)
      session.console.write(help_of(command));
    else
      session.console.error(usage_message(app, error));
    return kUsage;
  }
  return session.exit_code;
}

int run_command_line(const std::vector<std::string>& words, std::ostream& out, Console& console) {
  Session session{console, "anisofront " + shell_line(words)};
  CLI::App app("Adaptive finite elements in two dimensions on anisotropic meshes", "anisofront");
  set_help_style(app);
  app.set_version_flag("--version", "anisofront " ANISOFRONT_VERSION, "The version");
  app.require_subcommand(1);
  add_verbosity(app, console);
  for (const Subcommand& subcommand : kSubcommands) {
    subcommand.add(app, session);
    app.get_subcommands([](CLI::App*) { return true; }).back()->group(subcommand.group);
  }
  app.footer(
      "The example below writes a study file, runs it and leaves a page to look at. `anisofront "
      "COMMAND --help` says what a command does, with examples.\n\nExamples:\n"
      "  anisofront new plate\n"
      "  anisofront run plate.toml");
  return parse_and_run(app, words, out, session);
}

int run_and_report_errors(const std::vector<std::string>& words, std::ostream& out,
                          Console& console) {
  try {
    return run_command_line(words, out, console);
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

}  // namespace

int run_program(int argc, char** argv, std::ostream& out, std::ostream& err) {
  const InterruptGuard guard;
  const auto start = std::chrono::steady_clock::now();
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  Console console(out, err);
  console.set_log_format(asked_log_format(words));
  const int code = run_and_report_errors(words, out, console);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  console.end_progress();
  console.event("finished", fmt::format("finished with exit code {}", code),
                {{"exit_code", code}, {"seconds", seconds.count()}});
  return code;
}

}  // namespace anisofront
