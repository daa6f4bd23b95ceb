#pragma once

#include <optional>
#include <string_view>

#include "solver/scalar_problem.hpp"

namespace anisofront {

/// A known solution of -div(a grad u) + c u = f with its data.
struct ExactSolution {
  ScalarFunction value;     ///< u
  VectorFunction gradient;  ///< grad u
  ScalarFunction source;    ///< f
  /// int a |grad u|^2 + c u^2 over the unit square, in closed form.
  std::optional<double> squared_energy;
};

/// u = g(x) g(y) on the unit square, g(s) = 1 - cosh((s - 1/2) / eps) / cosh(1 / (2 eps)),
/// eps = sqrt(a / c): layers of width eps along all four sides, u = 0 there. No overflow for any
/// eps > 0. Precondition: a > 0, c > 0.
ExactSolution product_layer(double diffusion, double reaction);

/// u = sin(pi x) sin(pi y) on the unit square, u = 0 on its sides. Precondition: a > 0, c >= 0.
ExactSolution sine_product(double diffusion, double reaction);

/// By the name of the study file: "product-layer" or "sine-product".
/// Throws UsageError for other names (listing these) and for coefficients outside the
/// preconditions.
ExactSolution exact_solution(std::string_view name, double diffusion, double reaction);

}  // namespace anisofront
