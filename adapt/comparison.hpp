#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "adapt/history.hpp"

namespace anisofront {

/// What the meshes of one mode take to reach an error; empty where they never had an error as large
/// (nothing is extrapolated).
struct SizeAtError {
  std::optional<double> vertices, dofs;
};

/// Isotropic against anisotropic meshes at equal error.
struct ModeComparison {
  /// What the compared variants share: their settings without mode and target.
  std::vector<std::pair<std::string, std::string>> settings;
  bool is_true_error = false;  ///< false: errors are estimates
  double error = 0;            ///< relative; the smallest that both modes have reached
  SizeAtError isotropic, anisotropic;
};

/// Groups the variants by all settings but "adapt.mode" and "adapt.target...", and compares the
/// modes of each group that has both. Points of a mode are the cycles from 1 on of all its
/// variants, less those that another one beats in size and error; sizes between two points are
/// interpolated log-log (at_equal_error()). True errors count where both modes have some, else
/// estimates; groups without errors are left out. In the order of the variants.
std::vector<ModeComparison> compare_modes(std::span<const VariantHistory> variants);

/// Anisotropic over isotropic; empty unless both are known.
std::optional<double> size_ratio(const std::optional<double>& anisotropic,
                                 const std::optional<double>& isotropic);

}  // namespace anisofront
