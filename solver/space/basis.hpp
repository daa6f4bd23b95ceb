#pragma once

#include <array>

#include "solver/space/element_map.hpp"

namespace anisofront {

/// Values and reference gradients of N functions at a reference point.
template <int N>
struct Basis {
  std::array<double, N> value{};
  std::array<Vector, N> gradient{};
};

/// Lagrange functions of the local nodes of Element (corners, edges, centre).
Basis<3> linear_triangle(ReferencePoint at);     ///< P1
Basis<6> quadratic_triangle(ReferencePoint at);  ///< P2
Basis<4> bilinear_quad(ReferencePoint at);       ///< Q1
Basis<8> serendipity_quad(ReferencePoint at);    ///< Q8, without the centre
Basis<9> biquadratic_quad(ReferencePoint at);    ///< Q2

/// Crouzeix-Raviart: 1 at the midpoint of edge k, 0 at those of the other edges.
Basis<3> crouzeix_raviart(ReferencePoint at);

/// 27 L1 L2 L3.
Basis<1> triangle_bubble(ReferencePoint at);

/// Traces on a curve edge at t in [0, 1]: vertices[0], vertices[1] (and the edge).
std::array<double, 2> linear_trace(double t);
std::array<double, 3> quadratic_trace(double t);

}  // namespace anisofront
