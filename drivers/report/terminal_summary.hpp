#pragma once

#include <string>

#include "drivers/base/json.hpp"

namespace anisofront {

/// What a run ends with on a terminal of so many columns: the tables of result_tables.hpp without
/// columns that say nothing (only "-", or everywhere the same, which a line below says once), and
/// without those of least interest where the terminal is too narrow. Of more than 30 variants only
/// the comparisons are shown, and how many variants ended in which way.
std::string terminal_summary(const Json& history, int columns);

}  // namespace anisofront
