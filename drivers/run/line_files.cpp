#include "drivers/run/line_files.hpp"

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "drivers/problem/samples.hpp"
#include "drivers/run/cycle_files.hpp"

namespace anisofront {

namespace fs = std::filesystem;

void write_profiles(const fs::path& folder, int cycle, const std::vector<Profile>& profiles) {
  if (profiles.empty()) return;
  const fs::path lines = folder / "lines";
  make_folder(lines);
  for (const Profile& profile : profiles) {
    write_text_file(lines / fmt::format("cycle-{}-{}.csv", cycle, profile.name),
                    table_csv(profile.values));
    if (profile.reference)
      write_text_file(lines / fmt::format("reference-{}.csv", profile.name),
                      table_csv(*profile.reference));
  }
}

void remove_profiles(const fs::path& folder, int first) {
  const fs::path lines = folder / "lines";
  if (!fs::is_directory(lines)) return;
  std::vector<fs::path> old;
  for (const fs::directory_entry& entry : fs::directory_iterator(lines)) {
    const std::string name = entry.path().filename().string();
    if (cycle_of(name) >= first || (first == 0 && name.starts_with("reference-")))
      old.push_back(entry.path());
  }
  for (const fs::path& path : old) fs::remove(path);
  if (fs::is_empty(lines)) fs::remove(lines);
}

}  // namespace anisofront
