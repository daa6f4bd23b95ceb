#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace anisofront {

/// Makes figures/ and report.html of a results folder from its history.json and its meshes: one
/// page without outside links, at most 15 MB. Returns what could not be drawn, one sentence each.
/// Throws UsageError when the folder holds no history.json and InputError when that is damaged.
std::vector<std::string> make_report(const std::filesystem::path& directory);

/// Makes one page of several results folders, as it is made of one; no figures.
/// Throws UsageError also when a folder is named twice.
void make_common_report(const std::vector<std::filesystem::path>& directories,
                        const std::filesystem::path& page);

}  // namespace anisofront
