#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "adapt/loop.hpp"
#include "drivers/study/study_file.hpp"

namespace anisofront {

/// Writes cycle-K.msh with the metric and the fields of the analysis as node and element data, and
/// the other formats asked for; with vtu also cycles.pvd, the time series for ParaView; and the
/// profiles (write_profiles()). Stages of the metric go to cycle-K-stages.msh, one tensor field
/// each, and as asked for to cycle-K-stages.vtu and cycle-K-STAGE.mesh with .sol.
void write_cycle(const std::filesystem::path& folder, const std::vector<std::string>& formats,
                 int cycle, const Mesh& mesh, const Analysis& analysis);

/// The number K of "cycle-K.msh", "cycle-K-stages.vtu", "cycle-K-NAME.csv" and the like; -1 for
/// other names.
int cycle_of(const std::string& name);

/// Removes the files of cycle `first` and later ones from the folder, profiles included, and what
/// was half written when an earlier run was killed.
void remove_cycles(const std::filesystem::path& folder, int first);

/// Settings of a variant for the history: what varies, and what decides how to read the numbers.
std::vector<std::pair<std::string, std::string>> variant_settings(const Variant& variant);

}  // namespace anisofront
