#pragma once

#include <array>
#include <vector>

#include "solver/plate/shear_tying.hpp"
#include "solver/space/basis.hpp"

namespace anisofront {

/// Element of Arnold and Falk, a family of TiedElement: w Crouzeix-Raviart, theta linear and a
/// bubble, shear strain constant. Takes every element as straight. An unknown w is the deflection
/// at the middle of an edge, equal to the mean over the edge.
struct ArnoldFalk {
  static constexpr Shape kShape = Shape::triangle;
  static constexpr int kDeflections = 3, kRotations = 4, kTies = 2;
  static constexpr int kUnknowns = kDeflections + 2 * kRotations;
  static constexpr int kDegree = 4, kBentDegree = 4;
  static constexpr bool kIsStraight = true;

  static Basis<kDeflections> deflections(ReferencePoint at) { return crouzeix_raviart(at); }
  static Basis<kRotations> rotations(ReferencePoint at);
  static std::array<Vector, kTies> shear_terms(ReferencePoint at);
  static std::vector<TieSample> ties() { return mean_ties(kShape, 0); }

  /// Local unknowns: theta_x, theta_y of the corners, w of the edges, then theta of the bubble.
  static constexpr int deflection_unknown(int i) { return 6 + i; }
  static constexpr int rotation_unknown(int i) { return i < 3 ? 2 * i : 9; }
};

}  // namespace anisofront
