#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/scalar/scalar_problem.hpp"

namespace anisofront {

/// A known solution of -div(a grad u) + b . grad u + c u = f with its data.
struct ExactSolution {
  ScalarFunction value;     ///< u
  VectorFunction gradient;  ///< grad u
  ScalarFunction source;    ///< f
  /// int a |grad u|^2 + c u^2 over the domain, where there is a closed form or reference value.
  std::optional<double> squared_energy;
};

/// u = g(x) g(y) on the unit square, g(s) = 1 - cosh((s - 1/2) / eps) / cosh(1 / (2 eps)),
/// eps = sqrt(a / c): layers of width eps along all four sides, u = 0 there. No overflow for any
/// eps > 0. Precondition: a > 0, c > 0.
ExactSolution product_layer(double diffusion, double reaction);

/// u = sin(pi x) sin(pi y) on the unit square, u = 0 on its sides. Precondition: a > 0, c >= 0.
ExactSolution sine_product(double diffusion, double reaction);

/// u = r^(2/3) sin(2 theta / 3) on the L shape (-1, 1)^2 without its quadrant x > 0, y < 0: u = 0
/// on the two sides at the corner (0, 0), f = c u; u itself is to be prescribed on the others. The
/// gradient, unbounded at the corner, is given as 0 in that one point. Precondition: a > 0, c >= 0.
ExactSolution corner_singularity(double diffusion, double reaction);

/// u = X(x) sin(pi y) on the unit square, b = (speed, 0), eps = a / speed,
/// X = x - (e^((x - 1) / eps) - e^(-1 / eps)) / (1 - e^(-1 / eps)): an exponential layer of width
/// eps at x = 1, u = 0 on all sides. Precondition: a > 0, c >= 0, speed > 0.
ExactSolution exponential_layer(double diffusion, double reaction, double speed);

/// u = X(x) Y(y), X as in exponential_layer(), Y = g of product_layer() of width sqrt(a / speed):
/// parabolic layers along y = 0 and y = 1 besides. Precondition: a > 0, c >= 0, speed > 0.
ExactSolution parabolic_layers(double diffusion, double reaction, double speed);

/// An internal layer u = tanh(d / width), d the signed distance to a line or a circle.
struct Front {
  Point point{0.5, 0.5};  ///< of the line, or the centre of the circle
  double angle = 0;       ///< of the line's normal, towards positive u (radians)
  double radius = 0;      ///< of the circle, u > 0 outside; 0: a line
  double width = 0.01;
};
/// On any domain; u itself is to be prescribed on the boundary. For a circle u has a kink of size
/// e^(-2 radius / width) at the centre, where the gradient is given as 0. Precondition: a > 0,
/// c >= 0, front.width > 0.
ExactSolution internal_front(double diffusion, double reaction, const Front& front);

/// What the solutions depend on.
struct ExactParameters {
  double diffusion = 1;
  double reaction = 0;
  Vector velocity;  ///< adds b . grad u to f; layers of convection need (speed, 0), speed > 0
  Front front;      ///< of "line-front" and "circle-front"
};

/// The names exact_solution() knows: "product-layer", "sine-product", "corner-singularity",
/// "exponential-layer", "parabolic-layers", "line-front", "circle-front".
std::vector<std::string> exact_solution_names();

/// Throws UsageError for other names (listing these) and for parameters outside the preconditions.
ExactSolution exact_solution(std::string_view name, const ExactParameters& parameters);
ExactSolution exact_solution(std::string_view name, double diffusion, double reaction);

}  // namespace anisofront
