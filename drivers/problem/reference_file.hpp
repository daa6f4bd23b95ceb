#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "adapt/profile.hpp"

namespace anisofront {

/// Reads a table with the names of its columns in the first line and numbers below, separated by
/// commas, as `solve` and `run` write them. Blank lines and what follows a # are skipped. Columns:
/// s, which must not fall, and some of `quantities`; x and y may be there and are left out.
/// Throws UsageError that starts with `place`, naming the file, its line and what was expected.
NumberTable read_reference_file(const std::filesystem::path& path,
                                const std::vector<std::string>& quantities,
                                const std::string& place);

}  // namespace anisofront
