#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "adapt/point_location.hpp"
#include "solver/plate/solve_plate.hpp"
#include "solver/scalar/solve_scalar.hpp"

namespace anisofront {

/// The values that a kind of problem has at a point, by name.
struct Quantities {
  std::vector<std::string> at_point;  ///< the values of a state
  /// Those along a line besides: components along its unit tangent s and its normal
  /// n = (s.y, -s.x), of a state as above.
  std::vector<std::string> along_line;
  std::function<std::vector<double>(const std::vector<double>& state, Vector tangent)> along;
};

/// u, u_x, u_y; u_n, u_s.
Quantities scalar_quantities();
/// w, theta_x, theta_y, M_xx, M_yy, M_xy, Q_x, Q_y; M_n = n.M n, M_s = s.M s, M_ns = n.M s, Q_n,
/// Q_s.
Quantities plate_quantities();

/// A solution at points, in the same shape for all kinds of problems.
struct PointState {
  Quantities quantities;
  std::function<std::vector<double>(const Location&)> at;  ///< as quantities.at_point
};

/// The mesh must outlive the result, the rest is shared with it.
PointState scalar_point_state(const FeMesh& mesh, std::shared_ptr<const ScalarSolution> solution);
PointState plate_point_state(const FeMesh& mesh, std::shared_ptr<const PlateProblem> problem,
                             std::shared_ptr<const PlateSolution> solution);

}  // namespace anisofront
