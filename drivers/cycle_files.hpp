#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "adapt/loop.hpp"
#include "drivers/study_file.hpp"

namespace anisofront {

/// Writes cycle-K.msh with the metric and the fields of the analysis as node and element data, and
/// the other formats asked for; with vtu also cycles.pvd, the time series for ParaView. Cycle 0
/// removes the cycle files of an earlier run from the folder.
void write_cycle(const std::filesystem::path& folder, const std::vector<std::string>& formats,
                 int cycle, const Mesh& mesh, const Analysis& analysis);

/// Settings of a variant for the history: what varies, and what decides how to read the numbers.
std::vector<std::pair<std::string, std::string>> variant_settings(const Variant& variant);

}  // namespace anisofront
