#pragma once

#include <array>

#include "solver/scalar/scalar_basis.hpp"

namespace anisofront {

// Streamline upwind Petrov-Galerkin: sum_K int tau (b . grad v) (b . grad u + c u - a Lap u - f).
// A. N. Brooks, T. J. R. Hughes, Comput. Meth. Appl. Mech. Engng 32 (1982) 199-259,
// doi:10.1016/0045-7825(82)90071-8.

/// Length of an element along the flow, 2 |b| / sum_i |b . grad N_i| with the functions of the
/// corners: the short edge of a stretched element when the flow runs across it.
/// `gradients`: of the order 1 basis in x. Zero where b is zero.
double flow_length(Vector velocity, int corners, const std::array<Vector, 9>& gradients);

/// h / (2 |b|) (coth Pe - 1 / Pe), Pe = |b| h / (2 a): nodally exact in one dimension. Zero below
/// Pe = 1, where the plain method does not oscillate. h is the distance of nodes along the flow:
/// the flow length, half of it for order 2. Precondition: diffusion > 0.
double supg_time(Vector velocity, double diffusion, double node_distance);

/// Lap N_i of the basis in x, on bent and distorted elements too: with G = grad xi_a . grad xi_b,
/// G : (H(N) - sum_c dN/dx_c H(x_c)), H the second derivatives on the reference element.
/// `gradients`: of the basis in x.
std::array<double, 9> basis_laplacians(const Element& element, int order, ReferencePoint at,
                                       const std::array<Vector, 9>& gradients);

}  // namespace anisofront
