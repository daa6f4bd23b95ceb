#pragma once

#include <string>
#include <vector>

#include "drivers/history_json.hpp"

namespace anisofront {

/// A table of texts, ready to be set for a terminal or a page.
struct TextTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<bool> is_reference;  ///< per row: from the paper, not ours
  bool ends_in_text = false;       ///< the last column holds texts
};

/// The last cycle of every variant in the columns of the paper's Tables 1-4, then the share of
/// edges in the unit band, the range of the corner angles in the metric, the least scaled Jacobian
/// and the relative energy error; below a variant the row of the paper that
/// its study names. A prescribed metric has two rows, against the formula and the background.
TextTable summary_table(const Json& history);

/// Every cycle of one variant.
TextTable cycle_table(const Json& variant);

/// Columns aligned with spaces, texts (the first two columns) left and numbers right, a rule below
/// the header.
std::string as_text(const TextTable& table);

}  // namespace anisofront
