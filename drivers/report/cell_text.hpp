#pragma once

#include <cmath>
#include <string>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/json.hpp"

namespace anisofront {

/// The cell of a table for a number, "-" for anything else.
inline std::string number_cell(const Json& value, const char* format) {
  return value.is_number() ? fmt::format(fmt::runtime(format), value.get<double>()) : "-";
}

/// A percentage, cut and not rounded: "100.0" means all.
inline std::string percent_cell(const Json& value, int digits) {
  constexpr double kRounding = 1e-6;
  if (!value.is_number()) return "-";
  const double scale = std::pow(10, digits);
  return fmt::format("{:.{}f}", std::floor(scale * value.get<double>() + kRounding) / scale,
                     digits);
}

}  // namespace anisofront
