#pragma once

#include <vector>

#include "solver/space/element_map.hpp"

namespace anisofront {

/// One term of a tying condition. A condition ("tie") is a linear functional of the covariant shear
/// strain g = grad_ref w - J theta on the reference element: the sum of direction . g(at) over its
/// samples; a reduced shear strain g~ must have the same ties as g.
struct TieSample {
  int tie = 0;
  ReferencePoint at;
  Vector direction;
};

/// g . t at the two Gauss points of each edge (t: the edge as a vector): ties 2 k and 2 k + 1 of
/// edge k.
std::vector<TieSample> edge_ties(Shape shape);

/// Integrals over the reference element of both components of g (exact for g that are polynomials
/// of degree 4 on the triangle, 5 in each variable on the square): ties `first` and `first` + 1.
std::vector<TieSample> mean_ties(Shape shape, int first);

/// edge_ties(), then mean_ties().
std::vector<TieSample> edge_and_mean_ties(Shape shape);

}  // namespace anisofront
