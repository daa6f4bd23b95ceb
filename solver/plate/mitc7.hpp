#pragma once

#include <array>
#include <vector>

#include "solver/plate/shear_tying.hpp"
#include "solver/space/basis.hpp"

namespace anisofront {

/// MITC7, a family of TiedElement: w of second degree, theta of second degree and a bubble.
struct Mitc7 {
  static constexpr Shape kShape = Shape::triangle;
  static constexpr int kDeflections = 6, kRotations = 7, kTies = 8;
  static constexpr int kUnknowns = kDeflections + 2 * kRotations;
  /// On straight elements gradients of the bubble and shear terms are of degree 2, squares of 4.
  static constexpr int kDegree = 4, kBentDegree = 8;
  static constexpr bool kIsStraight = false;

  static Basis<kDeflections> deflections(ReferencePoint at) { return quadratic_triangle(at); }
  static Basis<kRotations> rotations(ReferencePoint at);
  static std::array<Vector, kTies> shear_terms(ReferencePoint at);
  static std::vector<TieSample> ties() { return edge_and_mean_ties(kShape); }

  /// Local unknowns: w, theta_x, theta_y of corners and edges, then theta of the bubble.
  static constexpr int deflection_unknown(int i) { return 3 * i; }
  static constexpr int rotation_unknown(int i) { return i < 6 ? 3 * i + 1 : 18; }
};

}  // namespace anisofront
