#include "adapt/fit_samples.hpp"

#include <cassert>
#include <cmath>

#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

constexpr std::size_t kMost = FitSamples::kMost;

/// Interpolation from the samples of a tensor rule to fewer points.
struct Interpolation {
  std::span<const WeightedPoint> targets;
  std::array<std::array<double, kMost>, 4> weights{};  ///< [target][sample]
};

/// The Lagrange function of a node among the three Gauss points 0 and +-sqrt(0.6).
double at_three_nodes(double node, double t) {
  constexpr double kSquare = 0.6;
  if (std::abs(node) < 0.1) return 1 - t * t / kSquare;
  return t * (t + node) / (2 * kSquare);
}

Interpolation interpolation_of(int source_degree, int target_degree) {
  Interpolation result{reference_quadrature(Shape::quadrilateral, target_degree), {}};
  const auto sources = reference_quadrature(Shape::quadrilateral, source_degree);
  for (std::size_t i = 0; i < result.targets.size(); ++i)
    for (std::size_t j = 0; j < sources.size(); ++j) {
      const ReferencePoint t = result.targets[i].at, s = sources[j].at;
      result.weights[i][j] =
          sources.size() == 4 ? 0.25 : at_three_nodes(s.xi, t.xi) * at_three_nodes(s.eta, t.eta);
    }
  return result;
}

void interpolate(const Interpolation& interpolation, const FluxSamples& samples,
                 const Element& element, FitSamples& fit) {
  const Index first = samples.first[element.number];
  const int sources = samples.first[element.number + 1] - first;
  const double* values = &samples.values[static_cast<std::size_t>(first) * samples.components];
  fit.count = static_cast<int>(interpolation.targets.size());
  for (int i = 0; i < fit.count; ++i) {
    fit.points[i] = map_at(element, interpolation.targets[i].at).x;
    fit.weights[i] = 1. / fit.count;
    fit.values[i].fill(0);
    for (int j = 0; j < sources; ++j)
      for (int c = 0; c < samples.components; ++c)
        fit.values[i][c] += interpolation.weights[i][j] * values[j * samples.components + c];
  }
}

void copy(const FluxSamples& samples, const Element& element, FitSamples& fit) {
  const auto first = static_cast<std::size_t>(samples.first[element.number]);
  fit.count = samples.first[element.number + 1] - samples.first[element.number];
  assert(fit.count <= FitSamples::kMost);
  double area = 0;
  for (int i = 0; i < fit.count; ++i) area += samples.weights[first + i];
  for (int i = 0; i < fit.count; ++i) {
    fit.points[i] = samples.points[first + i];
    fit.weights[i] = samples.weights[first + i] / area;
    for (int c = 0; c < samples.components; ++c)
      fit.values[i][c] = samples.values[(first + i) * samples.components + c];
  }
}

}  // namespace

void collect_fit_samples(const FluxSamples& samples, const Element& element, FitSamples& fit) {
  static const Interpolation to_centre = interpolation_of(3, 1), to_gauss = interpolation_of(5, 3);
  const int count = samples.first[element.number + 1] - samples.first[element.number];
  const bool is_straight_quad = element.shape == Shape::quadrilateral && !element.bent;
  if (is_straight_quad && count == 4) return interpolate(to_centre, samples, element, fit);
  if (is_straight_quad && count == 9) return interpolate(to_gauss, samples, element, fit);
  copy(samples, element, fit);
}

}  // namespace anisofront
