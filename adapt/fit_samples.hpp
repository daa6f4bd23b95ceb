#pragma once

#include <array>

#include "adapt/flux.hpp"

namespace anisofront {

/// What polynomials are fitted to on one element.
struct FitSamples {
  static constexpr int kMost = 9;
  int count = 0;
  std::array<Point, kMost> points;
  std::array<double, kMost> weights;  ///< sum 1
  std::array<std::array<double, kMaxFluxComponents>, kMost> values;
};

/// On straight quadrilaterals the stresses at the points where they superconverge, the centre for
/// first and 2 x 2 Gauss points for second order, interpolated from the samples (exactly, for
/// polynomials of the fit degree); on other elements the samples themselves. Fitted to all samples
/// of Q2, the quadratics keep a part of the error: the effectivity on a uniform mesh tends to 1.07
/// instead of 1. Precondition: at most kMost samples per element, as scalar_flux() and plate_flux()
/// take.
void collect_fit_samples(const FluxSamples& samples, const Element& element, FitSamples& fit);

}  // namespace anisofront
