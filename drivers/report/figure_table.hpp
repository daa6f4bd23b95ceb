#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "adapt/profile.hpp"

namespace anisofront {

/// A CSV file of numbers. Rows that are shorter than the header are left out, what is no number
/// becomes NaN. No columns when the file is empty. Throws UsageError when it cannot be read.
NumberTable read_number_table(const std::filesystem::path& path);

std::optional<std::size_t> column_of(const NumberTable& table, const std::string& name);

}  // namespace anisofront
