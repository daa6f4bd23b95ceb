#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mesher/geometry/point.hpp"

namespace anisofront {

using ScalarFunction = std::function<double(Point)>;
using VectorFunction = std::function<Vector(Point)>;

/// u = value on all mesh edges with this physical tag. Where two conditions meet in a vertex, the
/// first in the list holds.
struct DirichletCondition {
  Index tag = 0;
  ScalarFunction value;
};

/// -div(a grad u) + c u = f. Edges without a Dirichlet condition carry the natural one, no flux.
struct ScalarProblem {
  double diffusion = 1;   ///< a > 0
  double reaction = 0;    ///< c >= 0
  ScalarFunction source;  ///< f; empty: 0
  std::vector<DirichletCondition> dirichlet;
};

}  // namespace anisofront
