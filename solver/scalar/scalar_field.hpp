#pragma once

#include <vector>

#include "solver/space/dof_map.hpp"
#include "solver/space/element_map.hpp"
#include "solver/system/assemble.hpp"

namespace anisofront {

/// A finite element function of one component: order 1 is P1/Q1, order 2 is P2/Q2.
struct ScalarField {
  int order = 1;
  DofMap dofs;
  std::vector<double> values;  ///< vertices, then (order 2) edges
  std::vector<double> inner;   ///< order 2: the centres of the quadrilaterals
};

/// The linear field with these values at the vertices.
ScalarField linear_field(const FeMesh& mesh, std::vector<double> vertex_values);

/// Value and gradient of a field at a reference point of an element.
struct ScalarState {
  double value = 0;
  Vector gradient;
};
ScalarState scalar_state(const FeMesh& mesh, const ScalarField& field, const Element& element,
                         ReferencePoint at);

/// A field on one element, for many points of it.
struct ScalarOnElement {
  Element element;
  int order = 1;
  LocalValues values;

  ScalarState at(ReferencePoint at) const;
};
ScalarOnElement on_element(const FeMesh& mesh, const ScalarField& field, const Element& element);

}  // namespace anisofront
