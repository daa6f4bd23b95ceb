#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/base/json.hpp"

namespace anisofront {

/// What decides the looks of a curve.
struct CurveKind {
  std::string label;
  bool is_isotropic = false;
  std::string elements;  ///< "triangle", "quadrilateral", "mixed"
};
CurveKind curve_kind(const Json& variant);

struct CurveLook {
  std::string style;  ///< "linestyle 1 pointtype 7"
  std::string label;  ///< in the legend; empty: not there
};

/// Colours tell the modes, markers the elements; where all are alike, colours and markers tell the
/// curves. More than twelve curves are told apart by mode and elements only, once in the legend.
std::vector<CurveLook> curve_looks(const std::vector<CurveKind>& kinds);

/// One cycle of a variant.
struct SeriesPoint {
  std::string variant;
  int cycle = 0;
  double unknowns = 0;
  std::optional<double> error, estimate, effectivity;  ///< true error, estimated error
};

/// Variants that differ in their target only: the last cycle of each makes a curve, the cycles from
/// 1 on that led there are `before`. Of a single variant all cycles make the curve.
struct Series {
  CurveKind kind;
  std::vector<SeriesPoint> curve, before;
};

/// Of all variants with a known error, labelled by the settings that tell them apart.
std::vector<Series> error_series(const Json& history);

}  // namespace anisofront
