// K.J. Bathe, F. Brezzi, S.W. Cho, The MITC7 and MITC9 plate bending elements, Computers &
// Structures 32 (1989) 797-814, doi:10.1016/0045-7949(89)90365-9.
#include "solver/plate/mitc7.hpp"

#include <algorithm>

namespace anisofront {

Basis<Mitc7::kRotations> Mitc7::rotations(ReferencePoint at) {
  const Basis<6> p2 = quadratic_triangle(at);
  const Basis<1> bubble = triangle_bubble(at);
  Basis<kRotations> basis;
  std::copy(p2.value.begin(), p2.value.end(), basis.value.begin());
  std::copy(p2.gradient.begin(), p2.gradient.end(), basis.gradient.begin());
  basis.value.back() = bubble.value[0];
  basis.gradient.back() = bubble.gradient[0];
  return basis;
}

/// All linear fields and those of second degree whose tangential component is linear on each edge:
/// the rotated Raviart-Thomas space of degree 1.
std::array<Vector, Mitc7::kTies> Mitc7::shear_terms(ReferencePoint at) {
  const double x = at.xi, y = at.eta;
  return {{{1, 0}, {x, 0}, {y, 0}, {0, 1}, {0, x}, {0, y}, {x * y, -x * x}, {y * y, -x * y}}};
}

}  // namespace anisofront
