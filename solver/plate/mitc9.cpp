// K.J. Bathe, F. Brezzi, S.W. Cho, The MITC7 and MITC9 plate bending elements, Computers &
// Structures 32 (1989) 797-814, doi:10.1016/0045-7949(89)90365-9. The shell element of the same
// name ties 6 points per component and has a ninth deflection; it locks on distorted stretched
// quadrilaterals, this one does not.
#include "solver/plate/mitc9.hpp"

namespace anisofront {

/// The rotated Brezzi-Douglas-Fortin-Marini space of degree 2: each component linear along the
/// edges that it is tangential to.
std::array<Vector, Mitc9::kTies> Mitc9::shear_terms(ReferencePoint at) {
  const double x = at.xi, y = at.eta;
  return {{{1, 0},
           {x, 0},
           {y, 0},
           {x * y, 0},
           {y * y, 0},
           {0, 1},
           {0, x},
           {0, y},
           {0, x * y},
           {0, x * x}}};
}

}  // namespace anisofront
