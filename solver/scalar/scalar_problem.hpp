#pragma once

#include <vector>

#include "solver/space/coefficient.hpp"

namespace anisofront {

/// u = value on all mesh edges with this physical tag. Where two conditions meet in a vertex, the
/// first in the list holds.
struct DirichletCondition {
  Index tag = 0;
  Coefficient value;
};

/// a du/dn + transfer u = flux on all mesh edges with this physical tag, n outward: Neumann with
/// transfer 0, else Robin (transfer >= 0). On an edge between two elements this is the sum of the
/// fluxes out of both sides: a line source.
struct FluxCondition {
  Index tag = 0;
  Coefficient flux;
  Coefficient transfer;
};

/// u = value at the vertex next to `at` (embed a point there to get one in the very place).
struct PointValue {
  Point at;
  double value = 0;
};

/// -div(a grad u) + b . grad u + c u = f. Edges without a condition carry no flux.
struct ScalarProblem {
  RegionCoefficient diffusion = 1.;  ///< a > 0
  RegionCoefficient reaction = 0.;   ///< c >= 0
  RegionCoefficient source = 0.;     ///< f
  std::vector<DirichletCondition> dirichlet{};
  std::vector<FluxCondition> fluxes{};
  std::vector<PointValue> points{};
  RegionCoefficient velocity_x = 0.;  ///< b
  RegionCoefficient velocity_y = 0.;

  bool has_convection() const { return !velocity_x.is_zero() || !velocity_y.is_zero(); }
};

}  // namespace anisofront
