#pragma once

#include <array>

#include "mesher/front/ideal_point.hpp"

namespace anisofront {

/// Where a right isosceles triangle over AB has its apex, two of which form a square: the front
/// that prepares quadrilaterals (formation right_angle).
///
/// A base of length 1.2 and below is a leg: C lies above A or B, AB turned by 90 degrees in the
/// metric there, at unit length. Of two equally good places that above A comes first, so that the
/// triangles of a layer lie the same way and pair up. A longer base is a hypotenuse: C lies above
/// its midpoint at 1/sqrt2, so that both legs are near 1.
struct RightAngleOffset {
  Point midpoint;                    ///< towards which C is contracted
  std::array<TrialPoint, 2> trials;  ///< with the metric there, best first
  int count = 1;                     ///< of the trials: 2 above legs, 1 above hypotenuses
};

/// `steps`: most look-ups that correct the unit length where the size changes.
RightAngleOffset right_angle_offset(const BackgroundMesh& background, const WorkVertex& a,
                                    const WorkVertex& b, int steps);

/// mu~ of Eqn 17 for half squares: twice the area over the mean of the squared legs, in the mean
/// metric and with the right angle where that is largest, times a rational stand-in for e^(-delta),
/// delta the mean of |l - 1| over the legs. 1 for half a unit square; negative when the triangle is
/// clockwise.
double right_angle_mu(const WorkVertex& a, const WorkVertex& b, Point c, const MetricFactor& at_c);

}  // namespace anisofront
