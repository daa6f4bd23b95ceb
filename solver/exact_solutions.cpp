#include "solver/exact_solutions.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

/// g(s) of product_layer() in scaled form: with p = e^(-s/eps), q = e^(-(1-s)/eps) and
/// pq = e^(-1/eps), g = (1 - p)(1 - q) / (1 + pq), which neither overflows nor cancels.
struct Layer {
  double epsilon;

  double value(double s) const {
    return std::expm1(-s / epsilon) * std::expm1(-(1 - s) / epsilon) / (1 + std::exp(-1 / epsilon));
  }
  double slope(double s) const {
    return (std::exp(-s / epsilon) - std::exp(-(1 - s) / epsilon)) /
           (epsilon * (1 + std::exp(-1 / epsilon)));
  }
  /// int eps^2 g'^2 = eps T - 1 / (2 cosh^2(1/(2 eps))), T = tanh(1/(2 eps)).
  double slope_energy() const {
    const double e = std::exp(-1 / epsilon);
    return epsilon * tanh_half() - 2 * e / ((1 + e) * (1 + e));
  }
  /// int g^2, from int eps^2 g'^2 + g^2 = int g = 1 - 2 eps T.
  double square() const { return 1 - 2 * epsilon * tanh_half() - slope_energy(); }

 private:
  double tanh_half() const { return std::tanh(1 / (2 * epsilon)); }
};

}  // namespace

ExactSolution product_layer(double diffusion, double reaction) {
  const Layer g{std::sqrt(diffusion / reaction)};
  const double g0 = g.square(), g1 = g.slope_energy();
  return {
      [g](Point p) { return g.value(p.x) * g.value(p.y); },
      [g](Point p) {
        return Vector{g.slope(p.x) * g.value(p.y), g.value(p.x) * g.slope(p.y)};
      },
      // -eps^2 g'' + g = 1 in each variable.
      [g, reaction](Point p) {
        const double x = g.value(p.x), y = g.value(p.y);
        return reaction * (x + y - x * y);
      },
      reaction * (2 * g0 * g1 + g0 * g0),
  };
}

ExactSolution sine_product(double diffusion, double reaction) {
  constexpr double pi = std::numbers::pi;
  const double factor = 2 * pi * pi * diffusion + reaction;
  return {
      [](Point p) { return std::sin(pi * p.x) * std::sin(pi * p.y); },
      [](Point p) {
        return pi * Vector{std::cos(pi * p.x) * std::sin(pi * p.y),
                           std::sin(pi * p.x) * std::cos(pi * p.y)};
      },
      [factor](Point p) { return factor * std::sin(pi * p.x) * std::sin(pi * p.y); },
      factor / 4,
  };
}

ExactSolution exact_solution(std::string_view name, double diffusion, double reaction) {
  const bool layer = name == "product-layer";
  if (!layer && name != "sine-product")
    throw UsageError("unknown exact solution \"" + std::string(name) +
                     "\", expected \"product-layer\" or \"sine-product\"");
  if (!(diffusion > 0 && (layer ? reaction > 0 : reaction >= 0)))
    throw UsageError("exact solution \"" + std::string(name) +
                     "\" needs diffusion > 0 and reaction " + (layer ? "> 0" : ">= 0"));
  return layer ? product_layer(diffusion, reaction) : sine_product(diffusion, reaction);
}

}  // namespace anisofront
