#pragma once

#include <cmath>
#include <numbers>

#include "tests/solver/acceptance/graded_mesh.hpp"
#include "tests/solver/acceptance/square_plates.hpp"

namespace anisofront::acceptance {

/// The plate x > 0 under q = cos 2 pi y with D = 1, nu = 0.3, k = 5/6 in closed form: with a = 2 pi
/// and b^2 = a^2 + 12 k / t^2
///   psi = [1/a^4 + (A + B x) e^(-a x)] cos a y,   p = C e^(-b x) sin a y,
///   w = psi - Lap psi / S,   theta = grad psi + (p_y, -p_x),   Q = -grad Lap psi - S (p_y, -p_x),
/// S = k G t / D. A, B and C follow from the three conditions of the edge x = 0. The first terms
/// decay over the wave length, p is the layer at the edge.
struct HalfPlane {
  SupportKind support;
  double thickness;
  double A, B, C;

  static constexpr double a = 2 * std::numbers::pi;
  double shear_stiffness() const { return 3.5 / (thickness * thickness); }
  double b() const { return std::sqrt(a * a + 10 / (thickness * thickness)); }

  /// Q_y / sin a y without the layer.
  double outer_shear(double x) const { return -a * (1 / (a * a) + 2 * a * B * std::exp(-a * x)); }

  PlateState at(Point p) const {
    const double decay = std::exp(-a * p.x), layer = C * std::exp(-b() * p.x);
    const double cosine = std::cos(a * p.y), sine = std::sin(a * p.y);
    // psi = f cos a y, Lap psi = g cos a y
    const double f = 1 / std::pow(a, 4) + (A + B * p.x) * decay,
                 f1 = (B - a * (A + B * p.x)) * decay, g = -1 / (a * a) - 2 * a * B * decay,
                 f2 = g + a * a * f, g1 = 2 * a * a * B * decay;
    PlateState state;
    state.x = p;
    state.w = (f - g / shear_stiffness()) * cosine;
    state.rotation = {(f1 + a * layer) * cosine, (-a * f + b() * layer) * sine};
    const double xx = (f2 - a * b() * layer) * cosine, yy = a * (-a * f + b() * layer) * cosine,
                 xy = 0.5 * (-a * (f1 + a * layer) - a * f1 - b() * b() * layer) * sine;
    state.moments = {-(xx + 0.3 * yy), -(yy + 0.3 * xx), -0.7 * xy};
    state.shear = {(-g1 - shear_stiffness() * a * layer) * cosine,
                   (a * g - shear_stiffness() * b() * layer) * sine};
    return state;
  }
};

/// The part 0 < x < 3, 0 < y < 1/4 (e^(-3 a) = 7e-9): symmetric about y = 0, antisymmetric about
/// y = 1/4, and at x = 3 all but free of changes along x.
inline PlateProblem half_plane_strip(SupportKind support, double thickness) {
  PlateProblem problem;
  problem.material = unit_plate(thickness);
  problem.load = [](Point p) { return std::cos(2 * std::numbers::pi * p.y); };
  problem.supports = {{test::kLeft, support, {}},
                      {test::kBottom, SupportKind::symmetry, {}},
                      {test::kRight, SupportKind::symmetry, {}},
                      {test::kTop, SupportKind::antisymmetry, {}}};
  return problem;
}

}  // namespace anisofront::acceptance
