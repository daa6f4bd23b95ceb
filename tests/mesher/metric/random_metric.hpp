#pragma once

#include <cmath>
#include <random>

#include "mesher/metric/metric.hpp"

namespace anisofront {

/// Metric of random direction, size in [0.01, 100] and stretch in [1, max_stretch], both
/// logarithmically uniform.
inline Metric random_metric(std::mt19937_64& random, double max_stretch) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double phi = 3.141592653589793 * unit(random);
  const double h1 = std::pow(10, 4 * unit(random) - 2);
  const double h2 = h1 * std::pow(max_stretch, unit(random));
  return metric_from_sizes(h1, h2, {std::cos(phi), std::sin(phi)});
}

/// Point in [-1, 1]^2.
inline Point random_point(std::mt19937_64& random) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const double x = coordinate(random);
  return {x, coordinate(random)};
}

}  // namespace anisofront
