#include "mesher/geometry/describe.hpp"

#include <cstdio>

namespace anisofront {

std::string describe(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string describe(Point point) {
  return "(" + describe(point.x) + ", " + describe(point.y) + ")";
}

}  // namespace anisofront
