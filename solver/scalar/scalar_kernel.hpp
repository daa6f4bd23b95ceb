#pragma once

#include "solver/scalar/scalar_problem.hpp"
#include "solver/system/assemble.hpp"

namespace anisofront {

/// Fills the element matrix and load of the problem, int a grad u . grad v + (b . grad u + c u) v
/// = int f v with SUPG terms where the flow dominates (supg.hpp; grad a is left out of their
/// residual), for order 1 or 2. Straight triangles whose coefficients are constant take reference
/// matrices, the others quadrature: of degree 6 on triangles, 3 x 3 points (coefficients constant)
/// or 4 x 4 points on quadrilaterals. The kernel refers to `problem`, which must outlive it; it
/// throws InputError naming coefficient and place: not finite, a <= 0, c < 0; and for elements that
/// are turned inside out or flat, see positive_determinant().
ElementKernel scalar_kernel(const ScalarProblem& problem, int order);

}  // namespace anisofront
