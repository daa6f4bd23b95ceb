#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesher/geometry/monitor.hpp"

namespace anisofront {

/// What `anisofront new` is asked for.
struct NewStudy {
  std::string name;  ///< of the file, with or without folder and ".toml"
  std::string kind;  ///< of study_templates(); empty: `name` where it is one of
                     ///< them, else the first
};

/// Writes the study file NAME.toml and the mesh it reads, if any. Returns what was written, the
/// study first. Throws UsageError when a file exists already, which is never overwritten, and for
/// names that no file can have.
std::vector<std::filesystem::path> write_new_study(const NewStudy& wish,
                                                   const Monitor& monitor = {});

}  // namespace anisofront
