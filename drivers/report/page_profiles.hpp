#pragma once

#include <filesystem>

#include "drivers/base/json.hpp"

namespace anisofront {

/// The values along the lines of a variant, from lines/cycle-K-NAME.csv and reference-NAME.csv:
/// [{"name", "columns":["s", "x", ...], "cycles":[{"cycle", "rows":[[...]]}],
/// "reference":{"columns", "rows"} or null}], by name and cycle. Numbers have 7 digits, those that
/// are not finite are null. An empty list without that folder; files of other names and damaged
/// ones are passed over.
Json profiles_json(const std::filesystem::path& folder);

}  // namespace anisofront
