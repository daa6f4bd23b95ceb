#pragma once

#include <string>
#include <vector>

namespace anisofront {

/// A row of Tables 1-4 of the paper, named after its figure.
struct PaperRow {
  const char* name;  ///< "13b"
  const char* type;  ///< I/A: isotropic or anisotropic, T/Q: triangles or quadrilaterals
  int vertices, elements, edges;
  double quality_mean, quality_min, percent_half, length_min, length_max;
};

/// Whether the mesh of a row consists of quadrilaterals.
bool has_quads(const PaperRow& row);

/// The row of that name or nullptr.
const PaperRow* paper_row(const std::string& name);

/// Names of all rows.
std::vector<std::string> paper_row_names();

}  // namespace anisofront
