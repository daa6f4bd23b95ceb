#include <memory>

#include "drivers/commands/command_line.hpp"
#include "drivers/commands/commands.hpp"
#include "drivers/report/report.hpp"

namespace anisofront {

void add_report_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("report", "Page and figures of a results folder again");
  auto directory = std::make_shared<std::string>();
  command->add_option("DIR", *directory, "Folder that `anisofront run` has left")->required();
  add_verbosity(*command, console);
  command->footer("Example:\n  anisofront report example-2-results");
  command->callback([directory, &console] {
    for (const std::string& problem : make_report(*directory)) console.warn(problem);
    console.say("wrote " + (std::filesystem::path(*directory) / "report.html").string());
  });
}

}  // namespace anisofront
