#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/study/study.hpp"
#include "drivers/study/study_vary.hpp"

namespace anisofront {

/// One combination of the [vary] values.
struct Variant {
  std::string name;  ///< "isotropic-best"; "main" when nothing varies; usable as a folder name
  std::vector<Override> values;
  Study study;
};

/// A study with all its variants, in the order of the file, the last key varying fastest.
struct StudyFile {
  std::string title;
  std::filesystem::path path;
  std::vector<Variant> variants;
  std::string resolved;  ///< the study as run, --set applied and paths made absolute, as TOML
};

/// Reads a study file and applies `overrides` (bare words are texts). Every variant is parsed, so
/// mistakes are found before anything runs. Throws as parse_study() does, naming the combination.
StudyFile read_study_file(const std::filesystem::path& path,
                          const std::vector<Override>& overrides = {});

}  // namespace anisofront
