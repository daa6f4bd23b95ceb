#pragma once

#include <string>

#include "mesher/geometry/point.hpp"

namespace anisofront {

/// A number as messages show it, ten significant digits: "0.25".
std::string describe(double value);

/// A point as messages show it: "(0.25, 3)".
std::string describe(Point point);

}  // namespace anisofront
