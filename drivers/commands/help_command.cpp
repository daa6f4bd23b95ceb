#include <memory>

#include "drivers/commands/command_line.hpp"
#include "drivers/commands/command_tree.hpp"
#include "drivers/commands/commands.hpp"

namespace anisofront {

void add_help_command(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand("help", "The help of a command");
  auto words = std::make_shared<std::vector<std::string>>();
  command->add_option("COMMAND", *words, "Name of the command (default: the program)");
  add_verbosity(*command, session.console);
  command->footer(
      "The same as `anisofront COMMAND --help`.\n\nExample:\n"
      "  anisofront help metric explain");

  command->callback(
      [words, &app, &session] { session.console.write(help_of(find_command(app, *words))); });
}

}  // namespace anisofront
