#include "drivers/report/figure_folder.hpp"

#include <array>
#include <sstream>

#include "drivers/base/text.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

const char* const kList = "made.txt";
constexpr std::array<const char*, 5> kSuffixes{".svg", ".pdf", ".png", ".dat", ".gp"};

/// A name of a file in the folder itself; a list that was tampered with reaches no other.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name.find('/') == std::string::npos && name != "." && name != "..";
}

void remove_listed(const fs::path& folder) {
  if (!fs::is_regular_file(folder / kList)) return;
  std::istringstream lines(read_text_file(folder / kList));
  std::error_code ignored;  // what cannot be removed is overwritten or says so
  for (std::string name; std::getline(lines, name);)
    if (is_plain_name(name) && fs::is_regular_file(folder / name))
      fs::remove(folder / name, ignored);
}

}  // namespace

FigureFolder::FigureFolder(const fs::path& path) : path_(path) {
  make_folder(path_);
  remove_listed(path_);
}

std::string FigureFolder::free_stem(const std::string& wanted) {
  std::string stem = wanted;
  for (int k = 2; !stems_.insert(stem).second; ++k) stem = wanted + "-" + std::to_string(k);
  return stem;
}

void FigureFolder::write(const std::string& name, std::string_view content) {
  write_text_file(path_ / name, content);
  made_.insert(name);
}

bool FigureFolder::add(const std::string& name) {
  if (!fs::is_regular_file(path_ / name)) return false;
  made_.insert(name);
  return true;
}

std::vector<std::string> FigureFolder::files_of(const std::string& stem) const {
  std::vector<std::string> files;
  for (const char* suffix : kSuffixes)
    if (made_.contains(stem + suffix)) files.push_back(stem + suffix);
  return files;
}

void FigureFolder::write_list() const {
  std::string list;
  for (const std::string& name : made_) list += name + "\n";
  write_text_file(path_ / kList, list);
}

}  // namespace anisofront
