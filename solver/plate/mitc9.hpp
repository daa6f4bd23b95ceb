#pragma once

#include <array>
#include <vector>

#include "solver/plate/shear_tying.hpp"
#include "solver/space/basis.hpp"

namespace anisofront {

/// MITC9 of Bathe and Brezzi, a family of TiedElement: w serendipity, theta biquadratic. On edges
/// w and theta are those of Mitc7.
struct Mitc9 {
  static constexpr Shape kShape = Shape::quadrilateral;
  static constexpr int kDeflections = 8, kRotations = 9, kTies = 10;
  static constexpr int kUnknowns = kDeflections + 2 * kRotations;
  static constexpr int kDegree = 5, kBentDegree = 7;
  static constexpr bool kIsStraight = false;

  static Basis<kDeflections> deflections(ReferencePoint at) { return serendipity_quad(at); }
  static Basis<kRotations> rotations(ReferencePoint at) { return biquadratic_quad(at); }
  static std::array<Vector, kTies> shear_terms(ReferencePoint at);
  static std::vector<TieSample> ties() { return edge_and_mean_ties(kShape); }

  /// Local unknowns: w, theta_x, theta_y of corners and edges, then theta of the centre.
  static constexpr int deflection_unknown(int i) { return 3 * i; }
  static constexpr int rotation_unknown(int i) { return i < 8 ? 3 * i + 1 : 24; }
};

}  // namespace anisofront
