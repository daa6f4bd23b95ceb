// K.J. Bathe, E.N. Dvorkin, A four-node plate bending element based on Mindlin/Reissner plate
// theory and a mixed interpolation, Int. J. Numer. Meth. Engng 21 (1985) 367-383,
// doi:10.1002/nme.1620210213.
#include "solver/plate/mitc4.hpp"

namespace anisofront {

std::array<Vector, Mitc4::kTies> Mitc4::shear_terms(ReferencePoint at) {
  return {{{1, 0}, {at.eta, 0}, {0, 1}, {0, at.xi}}};
}

/// The tangential component at the middle of each edge.
std::vector<TieSample> Mitc4::ties() {
  return {{0, {0, -1}, {1, 0}}, {1, {1, 0}, {0, 1}}, {2, {0, 1}, {1, 0}}, {3, {-1, 0}, {0, 1}}};
}

}  // namespace anisofront
