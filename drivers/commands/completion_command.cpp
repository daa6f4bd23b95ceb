#include <memory>

#include "drivers/base/text.hpp"
#include "drivers/commands/command_line.hpp"
#include "drivers/commands/command_tree.hpp"
#include "drivers/commands/commands.hpp"
#include "drivers/commands/completion.hpp"

namespace anisofront {
namespace {

struct CompletionArguments {
  std::string shell, file;
};

}  // namespace

void add_completion_command(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand("completion", "Completion of command lines for a shell");
  auto arguments = std::make_shared<CompletionArguments>();
  command->add_option("SHELL", arguments->shell, "The shell, bash or zsh")
      ->required()
      ->check(one_of({"bash", "zsh"}));
  command->add_option("-o,--output", arguments->file, "Write the script into this file instead")
      ->type_name("FILE");
  add_verbosity(*command, session.console);
  command->footer(
      "Prints a script. Where the program is installed it is in its place already. Otherwise, for "
      "bash, put the line `source <(anisofront completion bash)` into ~/.bashrc; for zsh, write "
      "it to a file _anisofront in a folder of the fpath.\n\nExamples:\n"
      "  anisofront completion bash > anisofront.bash\n"
      "  anisofront completion zsh -o _anisofront");
  command->callback([arguments, &app, &session] {
    const CommandHelp program = describe(app);
    const std::string script =
        arguments->shell == "bash" ? bash_completion(program) : zsh_completion(program);
    if (arguments->file.empty()) return session.console.write(script);
    write_text_file(arguments->file, script);
  });
}

}  // namespace anisofront
