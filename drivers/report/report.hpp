#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace anisofront {

/// Makes figures/ and report.html of a results folder from its history.json and the meshes of the
/// last cycles: one page without outside links. Returns what could not be drawn, one sentence each.
/// Throws UsageError when the folder holds no history.json and InputError when that is damaged.
std::vector<std::string> make_report(const std::filesystem::path& directory);

}  // namespace anisofront
