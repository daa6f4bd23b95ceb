#pragma once

#include "solver/plate/tied_element.hpp"

namespace anisofront::test {

/// The MITC9 of shells, a control: w biquadratic as theta, shear strain tied at 6 points per
/// component. It passes every test on rectangles and locks on distorted stretched quadrilaterals.
/// K.J. Bathe, E.N. Dvorkin, A formulation of general shell elements - the use of mixed
/// interpolation of tensorial components, Int. J. Numer. Meth. Engng 22 (1986) 697-722.
struct SixPointMitc9 {
  static constexpr Shape kShape = Shape::quadrilateral;
  static constexpr int kDeflections = 9, kRotations = 9, kTies = 12;
  static constexpr int kUnknowns = kDeflections + 2 * kRotations;
  static constexpr int kDegree = 5, kBentDegree = 7;
  static constexpr bool kIsStraight = false;

  static Basis<9> deflections(ReferencePoint at) { return biquadratic_quad(at); }
  static Basis<9> rotations(ReferencePoint at) { return biquadratic_quad(at); }

  static std::array<Vector, 12> shear_terms(ReferencePoint at) {
    const double x = at.xi, y = at.eta;
    return {{{1, 0},
             {x, 0},
             {y, 0},
             {x * y, 0},
             {y * y, 0},
             {x * y * y, 0},
             {0, 1},
             {0, x},
             {0, y},
             {0, x * y},
             {0, x * x},
             {0, x * x * y}}};
  }

  static std::vector<TieSample> ties() {
    std::vector<TieSample> samples;
    const double gauss = 1 / std::sqrt(3.), outer = std::sqrt(0.6);
    for (const double a : {-gauss, gauss})
      for (const double b : {-outer, 0., outer}) {
        samples.push_back({static_cast<int>(samples.size()), {a, b}, {1, 0}});
        samples.push_back({static_cast<int>(samples.size()), {b, a}, {0, 1}});
      }
    return samples;
  }

  static constexpr int deflection_unknown(int i) { return 3 * i; }
  static constexpr int rotation_unknown(int i) { return 3 * i + 1; }
};

inline constexpr DofLayout kSixPointLayout{3, 3, 0, 3};

inline ElementKernel six_point_kernel(const PlateProblem& problem) {
  return [&problem](const Element& element, ElementSystem& system) {
    fill_system<SixPointMitc9>(element, problem.material, problem.load.in(element.region), system);
  };
}

}  // namespace anisofront::test
