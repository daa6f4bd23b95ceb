#include "adapt/flux.hpp"

#include <cmath>
#include <numbers>

#include "adapt/element_loop.hpp"
#include "solver/scalar/scalar_boundary.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

constexpr int kConstantDegree = 1;
constexpr int kVariableTriangleDegree = 4;
constexpr int kFirstOrderQuadDegree = 3;
constexpr int kSecondOrderDegree = 4;

int first_order_degree(const Element& element, bool is_constant) {
  if (element.shape == Shape::quadrilateral) return kFirstOrderQuadDegree;
  return is_constant && !element.bent ? kConstantDegree : kVariableTriangleDegree;
}

int scalar_degree(const ScalarProblem& problem, int order, const Element& element) {
  if (order == 2) return kSecondOrderDegree;
  return first_order_degree(element, problem.diffusion.in(element.region).is_constant());
}

int plate_degree(PlateElement kind, const Element& element) {
  if (kind == PlateElement::mitc) return kSecondOrderDegree;
  return first_order_degree(element, false);
}

void write(double root_of_diffusion, const ScalarState& state, double* values) {
  values[0] = root_of_diffusion * state.gradient.x;
  values[1] = root_of_diffusion * state.gradient.y;
}

/// C = D [1 nu 0; nu 1 0; 0 0 1 - nu] on (xx, yy, sqrt(2) xy) has the eigenvalues D (1 + nu) for
/// the sum and D (1 - nu) for the difference of M_xx and M_yy and for M_xy.
void write(const PlateMaterial& material, const PlateState& state, double* values) {
  const double bending = material.bending_stiffness(), nu = material.poisson;
  const double of_sum = 1 / std::sqrt(bending * (1 + nu));
  const double of_difference = 1 / std::sqrt(bending * (1 - nu));
  const double of_shear = 1 / std::sqrt(material.shear_stiffness());
  const Moments& m = state.moments;
  const double sum = 0.5 * of_sum * (m.xx + m.yy), difference = 0.5 * of_difference * (m.xx - m.yy);
  values[0] = sum + difference;
  values[1] = sum - difference;
  values[2] = of_difference * std::numbers::sqrt2 * m.xy;
  values[3] = of_shear * state.shear.x;
  values[4] = of_shear * state.shear.y;
}

/// Points and weights of the rules that `degree_of(element)` chooses, no values yet.
template <class DegreeOf>
FluxSamples empty_samples(const FeMesh& mesh, int components, int degree,
                          const DegreeOf& degree_of) {
  FluxSamples samples;
  samples.components = components;
  samples.degree = degree;
  samples.first.assign(mesh.element_count() + 1, 0);
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    const auto rule = reference_quadrature(element.shape, degree_of(element));
    samples.first[e + 1] = samples.first[e] + static_cast<Index>(rule.size());
  }
  const auto count = static_cast<std::size_t>(samples.first.back());
  samples.points.resize(count);
  samples.weights.resize(count);
  samples.at.resize(count);
  samples.values.resize(count * static_cast<std::size_t>(components));
  return samples;
}

/// `on_element(element)` gives a function of (reference point, map, place for the values).
template <class DegreeOf, class OnElement>
FluxSamples sampled(const FeMesh& mesh, int components, int degree, const DegreeOf& degree_of,
                    const OnElement& on_element) {
  FluxSamples samples = empty_samples(mesh, components, degree, degree_of);
  for_each_index(mesh.element_count(), [&](Index e) {
    const Element element = element_at(mesh, e);
    const auto write_at = on_element(element);
    auto sample = static_cast<std::size_t>(samples.first[e]);
    for (const auto& [at, weight] : reference_quadrature(element.shape, degree_of(element))) {
      const MapPoint map = map_at(element, at);
      samples.points[sample] = map.x;
      samples.weights[sample] = weight * map.determinant();
      samples.at[sample] = at;
      write_at(at, map, &samples.values[sample * static_cast<std::size_t>(components)]);
      ++sample;
    }
  });
  return samples;
}

/// Edges of the curves with a tag that `has_condition`; on the boundary it does not matter.
template <class HasCondition>
std::vector<char> edges_with(const FeMesh& mesh, const HasCondition& has_condition) {
  std::vector<char> marks(mesh.edges.count(), 0);
  for (std::size_t i = 0; i < mesh.mesh.edges.size(); ++i)
    if (has_condition(mesh.mesh.edges[i].tag)) marks[mesh.edges.curve_edges[i]] = 1;
  return marks;
}

}  // namespace

FluxSamples scalar_flux(const FeMesh& mesh, const ScalarProblem& problem,
                        const ScalarField& field) {
  FluxSamples samples = sampled(
      mesh, 2, field.order,
      [&](const Element& element) { return scalar_degree(problem, field.order, element); },
      [&](const Element& element) {
        return [&a = problem.diffusion.in(element.region), u = on_element(mesh, field, element)](
                   ReferencePoint at, const MapPoint& map, double* values) {
          write(std::sqrt(a(map.x)), u.at(at), values);
        };
      });
  samples.jumps = edges_with(mesh, [&](Index tag) {
    return condition_on(problem.dirichlet, tag) >= 0 || condition_on(problem.fluxes, tag) >= 0;
  });
  return samples;
}

FluxSamples plate_flux(const FeMesh& mesh, const PlateProblem& problem,
                       const PlateSolution& solution) {
  const PlateElement kind = solution.element;
  FluxSamples samples = sampled(
      mesh, 5, kind == PlateElement::mitc ? 2 : 1,
      [&](const Element& element) { return plate_degree(kind, element); },
      [&](const Element& element) {
        return [&, &material = problem.material_in(element.region),
                u = local_values(mesh, solution.dofs, element, solution.values, solution.inner)](
                   ReferencePoint at, const MapPoint&, double* values) {
          write(material, plate_state(kind, material, element, u, at), values);
        };
      });
  samples.jumps = edges_with(mesh, [&](Index tag) {
    return condition_on(problem.supports, tag) >= 0 || condition_on(problem.edge_loads, tag) >= 0;
  });
  return samples;
}

std::vector<double> scalar_flux_at(const FeMesh& mesh, const ScalarProblem& problem,
                                   const ScalarField& field, const Element& element,
                                   ReferencePoint at) {
  const double a = problem.diffusion.in(element.region)(map_at(element, at).x);
  std::vector<double> values(2);
  write(std::sqrt(a), scalar_state(mesh, field, element, at), values.data());
  return values;
}

std::vector<double> plate_flux_at(const FeMesh& mesh, const PlateProblem& problem,
                                  const PlateSolution& solution, const Element& element,
                                  ReferencePoint at) {
  std::vector<double> values(5);
  write(problem.material_in(element.region), plate_state(mesh, problem, solution, element, at),
        values.data());
  return values;
}

}  // namespace anisofront
