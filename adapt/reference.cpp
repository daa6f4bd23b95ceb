#include "adapt/reference.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {

double energy_of_difference(
    const FluxSamples& fine, const FeMesh& coarse,
    const std::function<std::vector<double>(const Location&)>& coarse_flux) {
  PointLocation location(coarse);
  double sum = 0;
  for (std::size_t s = 0; s < fine.points.size(); ++s) {
    const std::vector<double> flux = coarse_flux(location.nearest(fine.points[s]));
    double square = 0;
    for (int c = 0; c < fine.components; ++c) {
      const double e = fine.values[s * fine.components + c] - flux[c];
      square += e * e;
    }
    sum += fine.weights[s] * square;
  }
  return std::sqrt(sum);
}

double energy_of(const FluxSamples& samples) {
  double sum = 0;
  for (std::size_t i = 0; i < samples.values.size(); ++i)
    sum += samples.weights[i / samples.components] * samples.values[i] * samples.values[i];
  return std::sqrt(sum);
}

std::optional<double> at_equal_error(std::span<const double> x, std::span<const double> y,
                                     double level) {
  for (std::size_t i = x.size(); i-- > 1;) {
    const auto [low, high] = std::minmax(y[i - 1], y[i]);
    if (!(low <= level && level <= high)) continue;
    if (low == high) return x[i];
    const double share = std::log(y[i - 1] / level) / std::log(y[i - 1] / y[i]);
    return x[i - 1] * std::pow(x[i] / x[i - 1], share);
  }
  if (x.size() == 1 && y[0] == level) return x[0];
  return {};
}

}  // namespace anisofront
