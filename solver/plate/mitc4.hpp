#pragma once

#include <array>
#include <vector>

#include "solver/plate/shear_tying.hpp"
#include "solver/space/basis.hpp"

namespace anisofront {

/// MITC4, a family of TiedElement: w and theta bilinear. Takes every element as straight.
struct Mitc4 {
  static constexpr Shape kShape = Shape::quadrilateral;
  static constexpr int kDeflections = 4, kRotations = 4, kTies = 4;
  static constexpr int kUnknowns = kDeflections + 2 * kRotations;
  static constexpr int kDegree = 3, kBentDegree = 3;
  static constexpr bool kIsStraight = true;

  static Basis<kDeflections> deflections(ReferencePoint at) { return bilinear_quad(at); }
  static Basis<kRotations> rotations(ReferencePoint at) { return bilinear_quad(at); }
  static std::array<Vector, kTies> shear_terms(ReferencePoint at);
  static std::vector<TieSample> ties();

  /// Local unknowns: w, theta_x, theta_y of the corners.
  static constexpr int deflection_unknown(int i) { return 3 * i; }
  static constexpr int rotation_unknown(int i) { return 3 * i + 1; }
};

}  // namespace anisofront
