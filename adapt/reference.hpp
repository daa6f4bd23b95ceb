#pragma once

#include <functional>
#include <optional>
#include <span>

#include "adapt/flux.hpp"
#include "adapt/point_location.hpp"

namespace anisofront {

/// Energy norm of the difference of two solutions, integrated over the samples of the finer one:
/// the true error of the coarser when the finer is much better (errors 5 times smaller give the
/// norm to 2 percent). `coarse_flux` evaluates the coarse stresses, `components` values, at a
/// location of the coarse mesh; samples outside it take the nearest location.
double energy_of_difference(const FluxSamples& fine, const FeMesh& coarse,
                            const std::function<std::vector<double>(const Location&)>& coarse_flux);

/// Energy norm of samples: sqrt(int |f|^2).
double energy_of(const FluxSamples& samples);

/// Value of x at y = level on the log-log polyline through (x_i, y_i), y decreasing in x; empty
/// outside the range of the points. Isotropic and anisotropic runs are compared at equal error with
/// it. Where y goes up again between points, the last crossing counts. Precondition: as many x as
/// y, all positive.
std::optional<double> at_equal_error(std::span<const double> x, std::span<const double> y,
                                     double level);

}  // namespace anisofront
