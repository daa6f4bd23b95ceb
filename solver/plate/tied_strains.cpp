#include "solver/plate/tied_strains.hpp"

#include <string>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {

double positive_determinant(const MapPoint& map, const Element& element) {
  const double determinant = map.determinant();
  if (!(determinant > 0))
    throw InputError("element " + std::to_string(element.number) + " is turned inside out at " +
                     describe(map.x) + "; expected convex elements with anticlockwise corners");
  return determinant;
}

}  // namespace anisofront
