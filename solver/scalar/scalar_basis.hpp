#pragma once

#include <array>
#include <span>

#include "solver/space/dof_map.hpp"
#include "solver/space/element_map.hpp"

namespace anisofront {

/// The nodal functions of an element of order 1 (P1, Q1) or 2 (P2, Q2) at a reference point, in the
/// local order of Element: corners, edges, centre.
struct ScalarBasis {
  int count = 0;
  std::array<double, 9> value{};
  std::array<Vector, 9> gradient{};  ///< on the reference element
};
ScalarBasis scalar_basis(Shape shape, int order, ReferencePoint at);

/// Second derivatives on the reference element.
struct ReferenceHessian {
  double xi_xi = 0, xi_eta = 0, eta_eta = 0;
};
std::array<ReferenceHessian, 9> scalar_basis_hessians(Shape shape, int order, ReferencePoint at);

/// A point of reference_quadrature() with the basis there.
struct ScalarBasisPoint {
  ReferencePoint at;
  double weight = 0;
  ScalarBasis basis;
};
/// The span refers to static tables. Precondition: order 1 or 2, 0 <= degree <= 12.
std::span<const ScalarBasisPoint> scalar_rule(Shape shape, int order, int degree);

/// One unknown per vertex; order 2: one per edge, and the centres of quadrilaterals as inner ones.
/// Throws std::out_of_range unless order is 1 or 2.
DofLayout scalar_layout(int order);

}  // namespace anisofront
