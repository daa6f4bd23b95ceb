#pragma once

#include <string>
#include <vector>

namespace anisofront {

/// A table of texts, ready to be set for a terminal or a page.
struct TextTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<bool> is_reference;  ///< per row: from the paper, not ours
  bool ends_in_text = false;       ///< the last column holds texts
};

/// Columns aligned with spaces, texts (the first column, the second where it has letters) left and
/// numbers right, a rule below the header.
std::string as_text(const TextTable& table);

}  // namespace anisofront
