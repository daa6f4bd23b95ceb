#include "solver/scalar/scalar_field.hpp"

#include "solver/scalar/scalar_basis.hpp"

namespace anisofront {

ScalarField linear_field(const FeMesh& mesh, std::vector<double> vertex_values) {
  return {1, make_dof_map(mesh, scalar_layout(1)), std::move(vertex_values), {}};
}

ScalarState ScalarOnElement::at(ReferencePoint at) const {
  const ScalarBasis basis = scalar_basis(element.shape, order, at);
  ScalarState state;
  Vector gradient;
  for (int i = 0; i < basis.count; ++i) {
    state.value += values[i] * basis.value[i];
    gradient = gradient + values[i] * basis.gradient[i];
  }
  state.gradient = map_at(element, at).gradient(gradient);
  return state;
}

ScalarOnElement on_element(const FeMesh& mesh, const ScalarField& field, const Element& element) {
  return {element, field.order, local_values(mesh, field.dofs, element, field.values, field.inner)};
}

ScalarState scalar_state(const FeMesh& mesh, const ScalarField& field, const Element& element,
                         ReferencePoint at) {
  return on_element(mesh, field, element).at(at);
}

}  // namespace anisofront
