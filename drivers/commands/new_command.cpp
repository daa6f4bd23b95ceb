#include <memory>

#include "drivers/base/shell_words.hpp"
#include "drivers/base/text.hpp"
#include "drivers/commands/command_line.hpp"
#include "drivers/commands/commands.hpp"
#include "drivers/commands/new_study.hpp"
#include "drivers/commands/study_templates.hpp"

namespace anisofront {
namespace {

void write_study(const NewStudy& wish, Console& console) {
  const std::vector<std::filesystem::path> written =
      write_new_study(wish, console.monitor("initial mesh"));
  for (const std::filesystem::path& path : written) console.say("wrote " + path.string());
  console.say("next: " + shell_line({"anisofront", "run", written.front().string()}));
}

}  // namespace

void add_new_command(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand("new", "A commented study file to start from");
  auto wish = std::make_shared<NewStudy>();
  command->add_option("NAME", wish->name, "Name of the study: NAME.toml is written")->required();
  std::vector<std::string> kinds, meanings;
  for (const StudyTemplate& kind : study_templates()) {
    kinds.push_back(kind.kind);
    meanings.push_back(kind.kind + ": " + kind.summary);
  }
  command
      ->add_option("--kind", wish->kind,
                   joined(meanings, "; ") + " (default: NAME where it is one of them, else " +
                       kinds.front() + ")")
      ->type_name("WORD")
      ->check(one_of(kinds));
  add_verbosity(*command, session.console);
  command->footer(
      "The file runs as it is; its comments say what every key means and what else can be said. "
      "Files that exist are never overwritten.\n\nExamples:\n"
      "  anisofront new layer\n"
      "  anisofront new floor --kind plate");
  command->callback([wish, &session] { write_study(*wish, session.console); });
}

}  // namespace anisofront
