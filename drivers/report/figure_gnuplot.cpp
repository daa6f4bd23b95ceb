#include "drivers/report/figure_gnuplot.hpp"

#include <optional>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/process.hpp"
#include "drivers/base/text.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFailures = 3;

/// The script that gnuplot complains about: messages begin with its name, `"NAME.gp" line 7: ...`.
std::optional<std::size_t> failed_script(const std::vector<std::string>& stems,
                                         const std::string& message) {
  for (std::size_t i = 0; i < stems.size(); ++i)
    if (message.find("\"" + stems[i] + ".gp\"") != std::string::npos) return i;
  return {};
}

/// The line of the message that says what is wrong.
std::string complaint(const ProgramRun& run) {
  const std::size_t at = run.messages.find("\" line ");
  if (at == std::string::npos) return fmt::format("it ended with status {}", run.status);
  const std::size_t begin = run.messages.rfind('\n', at) + 1;
  return run.messages.substr(begin, run.messages.find('\n', begin) - begin);
}

/// Cairo writes the time into a PDF: with it, equal runs would leave different files.
void remove_date(const fs::path& pdf) {
  constexpr std::string_view kKey = "/CreationDate (D:", kDate = "20000101000000";
  if (!fs::exists(pdf)) return;
  std::string bytes = read_text_file(pdf);
  const std::size_t at = bytes.rfind(kKey);
  if (at == std::string::npos || at + kKey.size() + kDate.size() > bytes.size()) return;
  write_text_file(pdf, bytes.replace(at + kKey.size(), kDate.size(), kDate));
}

std::string not_installed(const fs::path& folder) {
  return "gnuplot is not installed: figures are left as data and scripts in " + folder.string() +
         "; `gnuplot make-all.gp` draws them there";
}

ProgramRun run_scripts(const fs::path& folder, const std::vector<std::string>& stems) {
  std::vector<std::string> words{"gnuplot", "-d"};  // without the settings of the user's home
  for (const std::string& stem : stems) words.push_back(stem + ".gp");
  return run_program_in(folder, words);
}

void skip(std::vector<std::string>& left, std::size_t count) {
  left.erase(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace

std::vector<std::string> run_gnuplot(const fs::path& folder,
                                     const std::vector<std::string>& stems) {
  std::vector<std::string> problems, left = stems;
  bool is_alone = false;  // a script per process, after one that ended without naming its script
  while (!left.empty() && problems.size() < kMostFailures) {
    const auto now = is_alone ? std::vector<std::string>{left.front()} : left;
    const ProgramRun run = run_scripts(folder, now);
    if (run.status == kProgramNotFound) return {not_installed(folder)};
    const auto failed = failed_script(now, run.messages);
    if (run.status == 0) {
      skip(left, now.size());
    } else if (failed || now.size() == 1) {
      problems.push_back(fmt::format("gnuplot cannot draw {}: {}",
                                     (folder / (now[failed.value_or(0)] + ".gp")).string(),
                                     complaint(run)));
      skip(left, failed.value_or(0) + 1);
    } else {
      is_alone = true;
    }
  }
  for (const std::string& stem : stems) remove_date(folder / (stem + ".pdf"));
  return problems;
}

}  // namespace anisofront
