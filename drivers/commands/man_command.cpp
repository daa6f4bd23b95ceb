#include <memory>

#include "drivers/base/text.hpp"
#include "drivers/commands/command_line.hpp"
#include "drivers/commands/command_tree.hpp"
#include "drivers/commands/commands.hpp"
#include "drivers/commands/man_page.hpp"

namespace anisofront {
namespace {

struct ManArguments {
  std::vector<std::string> words;
  std::string folder;
};

void write_man_pages(const CommandHelp& program, const std::filesystem::path& folder) {
  make_folder(folder);
  for (const ManPage& page : man_pages(program)) write_text_file(folder / page.file, page.text);
}

}  // namespace

void add_man_command(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand("man", "The manual page of a command");
  auto arguments = std::make_shared<ManArguments>();
  command->add_option("COMMAND", arguments->words, "Name of the command (default: the program)");
  command->add_option("-o,--output", arguments->folder, "Write all pages into this folder instead")
      ->type_name("DIR");
  add_verbosity(*command, session.console);
  command->footer(
      "Prints the page; `anisofront man run | man -l -` shows it.\n\nExamples:\n"
      "  anisofront man run\n"
      "  anisofront man -o man");
  command->callback([arguments, &app, &session] {
    if (!arguments->folder.empty()) return write_man_pages(describe(app), arguments->folder);
    const CommandHelp asked = describe(find_command(app, arguments->words));
    session.console.write(man_page(asked, {}));
  });
}

}  // namespace anisofront
