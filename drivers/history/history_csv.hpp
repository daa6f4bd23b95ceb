#pragma once

#include "drivers/history/history_json.hpp"

namespace anisofront {

/// history.csv: one line per variant and cycle with the columns of the JSON, for spreadsheets.
/// Columns of named values ("value NAME") come last.
/// Precondition: `history` comes from history_json().
std::string history_csv(const Json& history);

/// comparison.csv: one line per comparison, the settings as one text.
std::string comparison_csv(const Json& history);

/// "key = value, key = value" of an object with settings.
std::string settings_text(const Json& settings);

}  // namespace anisofront
