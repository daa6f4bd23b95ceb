#pragma once

#include <span>
#include <vector>

#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// Second derivatives of a scalar.
struct Hessian {
  double xx = 0;
  double xy = 0;
  double yy = 0;
};

/// Derivatives at a vertex of the quadratic that fits the values around it.
struct LocalQuadratic {
  Vector gradient;
  Hessian hessian;
};

/// Weighted least-squares quadratic through the vertices of the two-ring of each vertex (three-ring
/// where that has fewer than 10 vertices, as in corners; on whole edges a third ring measured
/// worse), in coordinates divided by the root of the patch covariance, weights 1/(1 + r^2).
/// `values`: one per vertex. Laws: exact for quadratics on any mesh whose patches determine one; an
/// affine map of the mesh transforms the result. A patch that does not determine a quadratic (fewer
/// than 6 vertices, or all on a conic) gives the fit of least norm in the patch coordinates.
std::vector<LocalQuadratic> fit_quadratics(const Mesh& mesh, std::span<const double> values);

}  // namespace anisofront
