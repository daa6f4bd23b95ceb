#include "drivers/study/paper_table.hpp"

#include <array>

namespace anisofront {
namespace {

/// Tables 1-4 as printed, except 12c: 743 elements are a misprint for 748 (Euler's formula).
constexpr std::array<PaperRow, 16> kRows{
    {{"12b", "A, T", 423, 748, 1170, 0.967, 0.652, 99.02, 0.55, 1.45},
     {"12c", "A, T", 423, 748, 1170, 0.967, 0.651, 99.81, 0.55, 1.45},
     {"12d", "A, T", 1704, 3266, 4969, 0.967, 0.601, 99.94, 0.55, 1.60},
     {"12e", "A, Q", 1651, 1582, 3232, 0.714, 0.185, 97.65, 0.35, 2.10},
     {"13b", "I, T", 2697, 4958, 7654, 0.964, 0.729, 99.28, 0.55, 1.75},
     {"13c", "I, Q", 2801, 2584, 5384, 0.720, 0.224, 98.86, 0.35, 1.90},
     {"13d", "A, T", 508, 916, 1423, 0.954, 0.536, 99.84, 0.65, 1.75},
     {"13e", "A, Q", 471, 422, 892, 0.673, 0.201, 97.32, 0.35, 1.85},
     {"14b", "I, T", 5495, 10871, 16365, 0.928, 0.574, 95.71, 0.40, 2.20},
     {"14c", "I, Q", 4905, 4843, 9747, 0.706, 0.223, 86.85, 0.25, 2.70},
     {"14d", "A, T", 1292, 2482, 3773, 0.857, 0.433, 95.47, 0.50, 2.10},
     {"14e", "A, Q", 1077, 1024, 2102, 0.602, 0.189, 82.45, 0.20, 2.95},
     {"15b", "I, T", 3362, 6128, 9492, 0.958, 0.510, 99.48, 0.50, 1.75},
     {"15c", "I, Q", 3478, 3181, 6661, 0.674, 0.201, 97.77, 0.25, 2.20},
     {"15d", "A, T", 1061, 1964, 3027, 0.909, 0.462, 98.76, 0.40, 2.35},
     {"15e", "A, Q", 1158, 1080, 2240, 0.641, 0.181, 95.41, 0.25, 2.80}}};

}  // namespace

bool has_quads(const PaperRow& row) { return row.type[3] == 'Q'; }

const PaperRow* paper_row(const std::string& name) {
  for (const PaperRow& row : kRows)
    if (name == row.name) return &row;
  return nullptr;
}

std::vector<std::string> paper_row_names() {
  std::vector<std::string> names;
  for (const PaperRow& row : kRows) names.emplace_back(row.name);
  return names;
}

}  // namespace anisofront
