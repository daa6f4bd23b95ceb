#pragma once

#include <optional>
#include <string>
#include <vector>

namespace anisofront {

/// Rows of numbers, as many in each as there are names of columns.
struct NumberTable {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

/// A solution along a line: one row per point with the columns s (length from the start), x, y and
/// the quantities of the problem (Quantities).
struct Profile {
  std::string name;  ///< of the line
  NumberTable values;
  /// What it is compared with: columns s and some of the quantities, at points of its own.
  std::optional<NumberTable> reference;
};

}  // namespace anisofront
