#pragma once

#include <filesystem>

#include "drivers/base/console.hpp"
#include "drivers/study/study_file.hpp"

namespace anisofront {

/// Solves the problem of every variant of a study once, on its initial mesh: solution.json,
/// solution.msh, solution.vtu (and the other formats asked for) and lines/NAME.csv in the directory
/// (several variants: one folder each, by name); the summary on the console. The files of a variant
/// are written when all of it is known, solution.json last.
/// Throws what the set-up, the mesher and the solver throw, naming the variant where there are
/// several; those before it are kept.
void solve_study(const StudyFile& study, const std::filesystem::path& directory, Console& console);

}  // namespace anisofront
