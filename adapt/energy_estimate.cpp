// O. C. Zienkiewicz, J. Z. Zhu, A simple error estimator and adaptive procedure, Int. J. Numer.
// Meth. Engng 24 (1987) 337-357, doi:10.1002/nme.1620240206.
#include "adapt/energy_estimate.hpp"

#include <cmath>

#include "solver/scalar/element_sum.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

/// Squares of blended linear polynomials, exactly.
constexpr int kBlendDegree = 4;
constexpr int kReactionDegree = 5;

struct Squares {
  double error = 0, energy = 0;

  Squares& operator+=(const Squares& b) {
    error += b.error;
    energy += b.energy;
    return *this;
  }
};

struct Difference {
  const FluxSamples& samples;
  const RecoveredFlux& recovered;

  Squares at(const Element& element, ReferencePoint at, Point x, double weight,
             Index sample) const {
    std::array<double, kMaxFluxComponents> flux{};
    recovered.evaluate(element, x, corner_functions(element.shape, at), flux.data());
    const double* computed = &samples.values[static_cast<std::size_t>(sample) * samples.components];
    Squares squares;
    for (int c = 0; c < samples.components; ++c) {
      squares.error += weight * (flux[c] - computed[c]) * (flux[c] - computed[c]);
      squares.energy += weight * flux[c] * flux[c];
    }
    return squares;
  }

  /// The computed stresses are constant there, the recovered ones are not.
  Squares over_constant(const Element& element, Index sample) const {
    Squares sum;
    for (const auto& [at, weight] : reference_quadrature(element.shape, kBlendDegree))
      sum += this->at(element, at, map_at(element, at).x, 2 * weight * samples.weights[sample],
                      sample);
    return sum;
  }

  Squares over(const Element& element) const {
    const Index first = samples.first[element.number], end = samples.first[element.number + 1];
    if (end - first == 1 && element.shape == Shape::triangle) return over_constant(element, first);
    Squares sum;
    for (Index s = first; s < end; ++s)
      sum += at(element, samples.at[s], samples.points[s], samples.weights[s], s);
    return sum;
  }
};

}  // namespace

ErrorEstimate estimate_by_recovery(const FeMesh& mesh, const FluxSamples& samples,
                                   const RecoveredFlux& recovered, double extra_energy) {
  const Difference difference{samples, recovered};
  ErrorEstimate estimate;
  estimate.indicators.resize(mesh.element_count());
  const auto sum = element_sum<Squares>(mesh.element_count(), 0, [&](Index e) {
    const Squares own = difference.over(element_at(mesh, e));
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
