#include <memory>

#include "drivers/commands/command_line.hpp"
#include "drivers/commands/commands.hpp"
#include "drivers/report/report.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

struct ReportArguments {
  std::vector<std::string> directories;
  std::string page;
};

void report(const ReportArguments& arguments, Console& console) {
  const std::vector<fs::path> directories(arguments.directories.begin(),
                                          arguments.directories.end());
  if (directories.size() == 1 && arguments.page.empty()) {
    for (const std::string& problem : make_report(directories[0])) console.warn(problem);
    console.say("wrote " + (directories[0] / "report.html").string());
    return;
  }
  const fs::path page = arguments.page.empty() ? "report.html" : arguments.page;
  make_common_report(directories, page);
  console.say("wrote " + page.string());
}

}  // namespace

void add_report_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand(
      "report", "Page and figures of a results folder again, or one page of several");
  auto arguments = std::make_shared<ReportArguments>();
  command->add_option("DIR", arguments->directories, "Folders that `anisofront run` has left")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("-o,--output", arguments->page,
                   "The page (default: report.html in DIR, of several in the current folder)")
      ->type_name("PAGE")
      ->check(file_name({".html"}));
  add_verbosity(*command, console);
  command->footer(
      "Makes the page and the figures of a results folder once more, from its history.json and "
      "meshes. Of several folders it makes one page that compares them.\n\n"
      "Examples:\n"
      "  anisofront report layer-results\n"
      "  anisofront report coarse-results fine-results -o comparison.html");
  command->callback([arguments, &console] { report(*arguments, console); });
}

}  // namespace anisofront
