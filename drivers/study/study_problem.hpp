#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "drivers/study/toml_table.hpp"
#include "solver/scalar/exact_solutions.hpp"

namespace anisofront {

/// u = value, or a du/dn + transfer u = flux, on the curves of one name.
struct ScalarBoundaryText {
  std::string curve;
  std::optional<ExpressionText> value, flux, transfer;
  bool is_exact = false;  ///< value = "exact": that of the known solution
  std::string place;
};

/// What is different in one region.
struct ScalarRegionText {
  std::string region;
  std::optional<ExpressionText> diffusion, reaction, source;
  std::optional<std::array<ExpressionText, 2>> velocity;
  std::string place;
};

struct ScalarPointText {
  Point at;
  double value = 0;
};

/// -div(diffusion grad u) + velocity . grad u + reaction u = source, as a study says it.
struct ScalarProblemText {
  std::string place;
  ExpressionNames names;
  int order = 1;  ///< of the elements: 1 or 2
  ExpressionText diffusion{"1", {}}, reaction{"0", {}};
  std::optional<ExpressionText> source;
  std::optional<std::array<ExpressionText, 2>> velocity;
  std::string exact;  ///< name of a known solution, or empty
  Front front;        ///< of the known solutions that are fronts
  std::vector<ScalarRegionText> regions;
  std::vector<ScalarBoundaryText> boundary;
  std::vector<ScalarPointText> points;

  bool has_convection() const;
};

/// Parameters of the known solution. Precondition: the study names one.
ExactParameters exact_parameters(const ScalarProblemText& problem);

/// The [problem] table of kind "poisson". Throws UsageError with file:line:column.
ScalarProblemText parse_scalar_problem(TomlTable table);

}  // namespace anisofront
