#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace anisofront {

/// The folder of the figures. It knows what was made in it, so that the next report can replace
/// that: files of the user under other names stay.
class FigureFolder {
 public:
  /// Creates the folder and removes what an earlier report has made there (listed in made.txt).
  explicit FigureFolder(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }

  /// A stem that no figure has yet: `wanted`, or with "-2", "-3", ... after it.
  std::string free_stem(const std::string& wanted);

  void write(const std::string& name, std::string_view content);

  /// Takes note of a file that something else has written; false when it is not there.
  bool add(const std::string& name);

  /// The files made for a stem, drawings first.
  std::vector<std::string> files_of(const std::string& stem) const;

  /// Writes made.txt.
  void write_list() const;

 private:
  std::filesystem::path path_;
  std::set<std::string> stems_;
  std::set<std::string> made_;
};

}  // namespace anisofront
