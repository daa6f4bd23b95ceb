#include "adapt/goal.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "adapt/element_loop.hpp"
#include "adapt/element_samples.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

/// Smallest weight of a Hessian as a share of the largest (FE.md 4).
constexpr double kLeastWeight = 1e-3;

using Stresses = std::array<double, kMaxFluxComponents>;

/// Integrals of f* - f_h: of the solution times the dual, of either squared.
struct Products {
  double mixed = 0, primal = 0, dual = 0;

  void add(double weight, const Stresses& u, const Stresses& z) {
    for (int c = 0; c < kMaxFluxComponents; ++c) {
      mixed += weight * u[c] * z[c];
      primal += weight * u[c] * u[c];
      dual += weight * z[c] * z[c];
    }
  }
};

/// Stresses of one solution, recovered and computed, and what tying takes from its shear strains.
struct Side {
  const FluxSamples& samples;
  const RecoveredFlux& recovered;
  const std::vector<double>& tying;

  Stresses at(const Element& element, const SampledPoint& point) const {
    Stresses stresses{};
    recovered.evaluate(element, point.x, corner_functions(element.shape, point.at),
                       stresses.data());
    return stresses;
  }
  void subtract_computed(Index sample, Stresses& stresses) const {
    const double* computed = &samples.values[static_cast<std::size_t>(sample) * samples.components];
    for (int c = 0; c < samples.components; ++c) stresses[c] -= computed[c];
  }
  /// Scaled shear forces (the last two stresses) times the mismatch.
  double mismatch(Index sample, const Stresses& stresses) const {
    if (tying.empty()) return 0;
    const double* gamma = &tying[2 * static_cast<std::size_t>(sample)];
    return gamma[0] * stresses[3] + gamma[1] * stresses[4];
  }
};

Products products_on(const Element& element, const Side& primal, const Side& dual) {
  Products sum;
  for_each_sampled_point(primal.samples, element, [&](double weight, const SampledPoint& point) {
    Stresses u = primal.at(element, point), z = dual.at(element, point);
    sum.mixed -= weight * (dual.mismatch(point.sample, u) + primal.mismatch(point.sample, z));
    primal.subtract_computed(point.sample, u);
    dual.subtract_computed(point.sample, z);
    sum.add(weight, u, z);
  });
  return sum;
}

/// Roots of the means of the squares over the elements around each vertex.
void set_weights(const FeMesh& mesh, const FluxSamples& samples,
                 const std::vector<Products>& products, GoalEstimate& estimate) {
  std::vector<double> area(mesh.mesh.points.size(), 0);
  estimate.primal_weights = estimate.dual_weights = area;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    for (int k = 0; k < element.corners; ++k) {
      const Index v = element.vertices[k];
      for (Index s = samples.first[e]; s < samples.first[e + 1]; ++s) area[v] += samples.weights[s];
      estimate.primal_weights[v] += products[e].primal;
      estimate.dual_weights[v] += products[e].dual;
    }
  }
  for (std::size_t v = 0; v < area.size(); ++v) {
    if (area[v] == 0) continue;
    for (auto* weights : {&estimate.primal_weights, &estimate.dual_weights})
      (*weights)[v] = std::sqrt((*weights)[v] / area[v]);
  }
}

std::vector<double> lifted(std::vector<double> weights) {
  const double least = kLeastWeight * *std::max_element(weights.begin(), weights.end());
  for (double& w : weights) w = std::max(w, least);
  return weights;
}

void require_fields(const FieldHessians& fields, std::size_t vertices, const std::string& what) {
  if (fields.empty())
    throw InputError("goal metric: no Hessians of " + what + ", expected at least one field");
  for (const std::vector<Hessian>& field : fields) {
    if (field.size() != vertices)
      throw InputError("goal metric: a field of " + what + " has " + std::to_string(field.size()) +
                       " Hessians, expected one per vertex: " + std::to_string(vertices));
    for (std::size_t v = 0; v < vertices; ++v)
      if (const Hessian& h = field[v]; !std::isfinite(h.xx + h.xy + h.yy))
        throw InputError("goal metric: a Hessian of " + what + " at vertex " +
                         std::to_string(v + 1) +
                         " is not finite, expected numbers; check the solution there");
  }
}

}  // namespace

GoalEstimate estimate_goal(const FeMesh& mesh, const FluxSamples& primal,
                           const RecoveredFlux& primal_recovered, const FluxSamples& dual,
                           const RecoveredFlux& dual_recovered, const TyingMismatch& tying) {
  const Side u{primal, primal_recovered, tying.primal}, z{dual, dual_recovered, tying.dual};
  std::vector<Products> products(mesh.element_count());
  for_each_index(mesh.element_count(),
                 [&](Index e) { products[e] = products_on(element_at(mesh, e), u, z); });
  GoalEstimate estimate;
  for (const Products& own : products) {
    estimate.error += own.mixed;
    estimate.indicators.push_back(std::abs(own.mixed));
  }
  set_weights(mesh, primal, products, estimate);
  return estimate;
}

std::vector<Hessian> goal_hessians(const FieldHessians& primal, const FieldHessians& dual,
                                   const GoalEstimate& estimate) {
  const std::size_t vertices = estimate.primal_weights.size();
  require_fields(primal, vertices, "the solution");
  require_fields(dual, vertices, "the dual solution");
  const std::vector<double> w_u = lifted(estimate.primal_weights),
                            w_z = lifted(estimate.dual_weights);
  std::vector<Hessian> sum(vertices);
  for_each_index(static_cast<Index>(vertices), [&](Index v) {
    const Hessian u = root_of_squares(primal, v), z = root_of_squares(dual, v);
    sum[v] = {w_z[v] * u.xx + w_u[v] * z.xx, w_z[v] * u.xy + w_u[v] * z.xy,
              w_z[v] * u.yy + w_u[v] * z.yy};
  });
  return sum;
}

}  // namespace anisofront
