#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapt/density.hpp"
#include "adapt/goal.hpp"
#include "adapt/steering.hpp"
#include "drivers/study/toml_table.hpp"

namespace anisofront {

/// What a study says about the limits of the metric; the rest follows from the problem
/// (metric_limits()). `false` stands for the value that limits nothing.
struct LimitsText {
  std::optional<double> hmin, hmax, stretch, gradation;
};

/// layer = { ... }, or false. Plates have defaults for all of it.
struct LayerText {
  bool is_on = true;
  std::optional<std::vector<std::string>> curves;
  std::optional<double> width, first_size, reach, growth;
  std::optional<bool> metric;  ///< the a-priori metric shapes the first mesh
  std::string place;
};

/// A quantity of interest, its curve or region still by name.
struct GoalText {
  Goal goal;
  std::string name;
  bool steers = true;  ///< false: only reported
  std::string place;
};

/// reference = true or { nodes = N }.
struct ReferenceText {
  double nodes = 0;  ///< 0: chosen by errors_against_reference()
};

/// The [adapt] table.
struct AdaptSection {
  int cycles = 5;
  AdaptMode mode = AdaptMode::anisotropic;
  Target target;  ///< at most one is set, none for a prescribed metric
  LimitsText limits;
  MetricNorm norm = MetricNorm::lp;
  double p = 2;
  Combination combination = Combination::sum_of_squares;
  double curvature_floor = DensityOptions{}.curvature_floor;
  bool align = true;
  bool equidistribute = true;  ///< the estimate decides how dense the elements are
  LayerText layer;
  std::optional<GoalText> goal;
  std::optional<ReferenceText> reference;
  StopRules stop;
  bool stages = false;  ///< analyses keep the stages of the metric
};

/// Throws UsageError with file:line:column for unknown keys and values out of range.
AdaptSection parse_adapt(TomlTable table);

/// Keys that say how errors become metrics, which a study without a [problem] has no use for.
const std::vector<std::string>& keys_for_problems();

}  // namespace anisofront
