#pragma once

#include "drivers/base/json.hpp"
#include "drivers/base/text_table.hpp"

namespace anisofront {

/// The last cycle of every variant in the columns of the paper's Tables 1-4, then the share of
/// edges in the unit band, the range of the corner angles in the metric, the least scaled Jacobian
/// and the relative energy error; below a variant the row of the paper that
/// its study names. A prescribed metric has two rows, against the formula and the background.
TextTable summary_table(const Json& history);

/// Every cycle of one variant.
TextTable cycle_table(const Json& variant);

}  // namespace anisofront
