#pragma once

#include "solver/plate/tied_tables.hpp"

namespace anisofront {

/// Ties of -J theta for theta_x and theta_y, by rotation function.
template <class Family>
struct RotationTies {
  Block<Family::kRotations, Family::kTies> x, y;
};

template <class Family>
RotationTies<Family> rotation_ties(const TiedTables<Family>& tables, const Element& element) {
  RotationTies<Family> ties;
  ties.x.setZero();
  ties.y.setZero();
  for (const auto& [tie, rotation] : tables.samples) {
    const MapPoint map = map_at(element, tie.at);
    const Vector along = tie.direction.x * map.d_xi + tie.direction.y * map.d_eta;
    for (int i = 0; i < Family::kRotations; ++i) {
      ties.x(i, tie.tie) -= along.x * rotation[i];
      ties.y(i, tie.tie) -= along.y * rotation[i];
    }
  }
  return ties;
}

/// What the functions do at a point of an element; two columns are the components in x and y.
template <class Family>
struct Strains {
  Block<Family::kRotations, 1> dx, dy;        ///< derivatives of the rotation functions
  Block<Family::kDeflections, 2> deflection;  ///< gamma of w
  Block<Family::kRotations, 2> x, y;          ///< gamma of theta_x, of theta_y
};

/// Rows of covariant components times this are rows in x and y (the transpose of J^-1).
inline Block<2, 2> inverse_jacobian(const MapPoint& map) {
  const double s = 1 / map.determinant();
  Block<2, 2> inverse;
  inverse << s * map.d_eta.y, -s * map.d_eta.x, -s * map.d_xi.y, s * map.d_xi.x;
  return inverse;
}

template <class Family>
Strains<Family> strains_at(const MapPoint& map, const RotationTies<Family>& ties,
                           const typename TiedTables<Family>::Functions& f) {
  const Block<2, 2> inverse = inverse_jacobian(map);
  const auto shear = product(f.shear, inverse);
  const Block<2, 1> to_x = inverse.col(0), to_y = inverse.col(1);
  return {product(f.rotation_gradient, to_x), product(f.rotation_gradient, to_y),
          product(f.deflection_shear, inverse), product(ties.x, shear), product(ties.y, shear)};
}

}  // namespace anisofront
