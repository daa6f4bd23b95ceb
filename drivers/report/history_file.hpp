#pragma once

#include <filesystem>

#include "drivers/base/json.hpp"

namespace anisofront {

/// The history.json of a results folder, with all that reports are made of: "comparison" is there
/// in any case. Later additions to schema 1 may be missing.
/// Throws UsageError when there is no such file and InputError, with the place, when it holds
/// something else.
Json read_history_file(const std::filesystem::path& directory);

}  // namespace anisofront
