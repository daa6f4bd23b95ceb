// D.N. Arnold, R.S. Falk, A uniformly accurate finite element method for the Reissner-Mindlin
// plate, SIAM J. Numer. Anal. 26 (1989) 1276-1290, doi:10.1137/0726074.
#include "solver/plate/arnold_falk.hpp"

#include <algorithm>

namespace anisofront {

Basis<ArnoldFalk::kRotations> ArnoldFalk::rotations(ReferencePoint at) {
  const Basis<3> p1 = linear_triangle(at);
  const Basis<1> bubble = triangle_bubble(at);
  Basis<kRotations> basis;
  std::copy(p1.value.begin(), p1.value.end(), basis.value.begin());
  std::copy(p1.gradient.begin(), p1.gradient.end(), basis.gradient.begin());
  basis.value.back() = bubble.value[0];
  basis.gradient.back() = bubble.gradient[0];
  return basis;
}

std::array<Vector, ArnoldFalk::kTies> ArnoldFalk::shear_terms(ReferencePoint) {
  return {{{1, 0}, {0, 1}}};
}

}  // namespace anisofront
