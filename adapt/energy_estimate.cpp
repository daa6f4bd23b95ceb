// O. C. Zienkiewicz, J. Z. Zhu, A simple error estimator and adaptive procedure, Int. J. Numer.
// Meth. Engng 24 (1987) 337-357, doi:10.1002/nme.1620240206.
#include "adapt/energy_estimate.hpp"

#include <cmath>

#include "adapt/element_samples.hpp"
#include "solver/scalar/element_sum.hpp"

namespace anisofront {
namespace {

constexpr int kReactionDegree = 5;

struct Squares {
  double error = 0, energy = 0;

  Squares& operator+=(const Squares& b) {
    error += b.error;
    energy += b.energy;
    return *this;
  }
};

Squares difference_on(const Element& element, const FluxSamples& samples,
                      const RecoveredFlux& recovered) {
  Squares sum;
  for_each_sampled_point(samples, element, [&](double weight, const SampledPoint& point) {
    std::array<double, kMaxFluxComponents> flux{};
    recovered.evaluate(element, point.x, corner_functions(element.shape, point.at), flux.data());
    const double* computed =
        &samples.values[static_cast<std::size_t>(point.sample) * samples.components];
    Squares squares;
    for (int c = 0; c < samples.components; ++c) {
      squares.error += weight * (flux[c] - computed[c]) * (flux[c] - computed[c]);
      squares.energy += weight * flux[c] * flux[c];
    }
    sum += squares;
  });
  return sum;
}

}  // namespace

ErrorEstimate estimate_by_recovery(const FeMesh& mesh, const FluxSamples& samples,
                                   const RecoveredFlux& recovered, double extra_energy) {
  ErrorEstimate estimate;
  estimate.indicators.resize(mesh.element_count());
  const auto sum = element_sum<Squares>(mesh.element_count(), 0, [&](Index e) {
    const Squares own = difference_on(element_at(mesh, e), samples, recovered);
    estimate.indicators[e] = std::sqrt(own.error);
    return own;
  });
  estimate.error = std::sqrt(sum.error);
  estimate.energy = std::sqrt(sum.energy + extra_energy);
  return estimate;
}

ErrorEstimate estimate_by_recovery(const FeMesh& mesh, const ScalarProblem& problem,
                                   const ScalarField& field) {
  const FluxSamples samples = scalar_flux(mesh, problem, field);
  return estimate_by_recovery(mesh, samples, RecoveredFlux(mesh, samples),
                              reaction_energy(mesh, problem, field));
}

ErrorEstimate estimate_by_recovery(const FeMesh& mesh, const PlateProblem& problem,
                                   const PlateSolution& solution) {
  const FluxSamples samples = plate_flux(mesh, problem, solution);
  return estimate_by_recovery(mesh, samples, RecoveredFlux(mesh, samples), 0);
}

double reaction_energy(const FeMesh& mesh, const ScalarProblem& problem, const ScalarField& field) {
  if (problem.reaction.is_zero()) return 0;
  return element_sum<double>(mesh.element_count(), 0, [&](Index e) {
    const ScalarOnElement u = on_element(mesh, field, element_at(mesh, e));
    const Coefficient& c = problem.reaction.in(u.element.region);
    double sum = 0;
    for (const auto& [at, weight] : reference_quadrature(u.element.shape, kReactionDegree)) {
      const MapPoint map = map_at(u.element, at);
      const double value = u.at(at).value;
      sum += weight * map.determinant() * c(map.x) * value * value;
    }
    return sum;
  });
}

}  // namespace anisofront
