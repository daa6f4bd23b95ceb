#pragma once

#include <span>

#include "solver/space/element_map.hpp"

namespace anisofront {

/// A point of a rule on a reference element; weights sum to its area (1/2, 4) or length (1).
struct WeightedPoint {
  ReferencePoint at;
  double weight = 0;
};

/// Exact for polynomials up to `degree`: in total on the triangle (triangle_quadrature()), in each
/// variable on the square (Gauss). The span refers to static tables.
/// Throws std::out_of_range unless 0 <= degree <= 12.
std::span<const WeightedPoint> reference_quadrature(Shape shape, int degree);

struct EdgeQuadraturePoint {
  double t = 0;  ///< in [0, 1]
  double weight = 0;
};

/// Gauss rule on [0, 1], exact up to `degree` (0 .. 13; throws std::out_of_range).
std::span<const EdgeQuadraturePoint> edge_quadrature(int degree);

}  // namespace anisofront
