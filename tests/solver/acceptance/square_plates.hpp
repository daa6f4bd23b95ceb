#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "solver/plate/solve_plate.hpp"
#include "tests/solver/square_mesh.hpp"

namespace anisofront::acceptance {

/// nu = 0.3, k = 5/6 and D = 1, so that k G t / D = 3.5 / t^2: the units of the references.
inline PlateMaterial unit_plate(double thickness) {
  PlateMaterial material;
  material.thickness = thickness;
  material.young = 12 * (1 - 0.3 * 0.3) / (thickness * thickness * thickness);
  return material;
}

/// Plates on the unit square: all sides softly supported, hard supported or clamped under q = 1;
/// x = 0 and 1 clamped, y = 0 and 1 free under q = 1; all sides free under cos 2 pi x cos 2 pi y.
enum class SquarePlate { soft, hard, clamped, clamped_free, free };

inline const char* name_of(SquarePlate plate) {
  constexpr std::array kNames{"soft", "hard", "clamped", "clamped-free", "free"};
  return kNames[static_cast<std::size_t>(plate)];
}

/// Of the sides x = 0 and 1, and of y = 0 and 1.
inline std::array<SupportKind, 2> supports_of(SquarePlate plate) {
  switch (plate) {
    case SquarePlate::soft:
      return {SupportKind::soft_support, SupportKind::soft_support};
    case SquarePlate::hard:
      return {SupportKind::hard_support, SupportKind::hard_support};
    case SquarePlate::clamped:
      return {SupportKind::clamped, SupportKind::clamped};
    case SquarePlate::clamped_free:
      return {SupportKind::clamped, SupportKind::free};
    case SquarePlate::free:
      break;
  }
  return {SupportKind::free, SupportKind::free};
}

/// The quarter [0, 1/2]^2 of a plate, kRight and kTop its lines of symmetry. The free one is held
/// at the centre.
inline PlateProblem quarter_plate(SquarePlate plate, double thickness) {
  PlateProblem problem;
  problem.material = unit_plate(thickness);
  const auto [left, bottom] = supports_of(plate);
  problem.supports = {{test::kLeft, left, {}},
                      {test::kBottom, bottom, {}},
                      {test::kRight, SupportKind::symmetry, {}},
                      {test::kTop, SupportKind::symmetry, {}}};
  problem.load = 1;
  if (plate != SquarePlate::free) return problem;
  problem.point_supports = {{{0.5, 0.5}, 0, false}};
  problem.load = [](Point p) {
    return std::cos(2 * std::numbers::pi * p.x) * std::cos(2 * std::numbers::pi * p.y);
  };
  return problem;
}

/// What holds for a whole plate. From /work/shared/references.json, the result of hp spectral
/// Galerkin methods with p = 12 on tensor meshes graded to the edges; with two other ones (p = 10,
/// and deeper grading) they agree to the digits that the tests ask for.
struct SquareReference {
  SquarePlate plate;
  double thickness;
  double w, mx, my;        ///< at the centre (w of the free plate: 0)
  double energy;           ///< 1/2 int q w
  double shear_energy;     ///< its part from shear (0: not known)
  double edge_w, edge_mx;  ///< at (1/2, 0)
  double edge_q;           ///< Q_x at (0, 1/2), normal to that edge
  double edge_s;           ///< Q_x at (1/4, 0), along that edge: the layer
};

inline constexpr std::array<SquareReference, 15> kSquareReferences{{
    {SquarePlate::soft, .1, 0.004616906708, 0.05095711, 0.05095711, 0.0009822142219, 8.84273061e-05,
     0, 0.00737245, 0.421838, -0.688409},
    {SquarePlate::soft, .01, 0.004099303808, 0.048195443, 0.048195443, 0.0008600094978,
     4.63319518e-06, 0, 0.000686526, 0.420793, -6.38296},
    {SquarePlate::soft, .001, 0.004065849943, 0.047917195, 0.047917195, 0.000852084234,
     4.17087186e-07, 0, 6.81452e-05, 0.420504, -63.2749},
    {SquarePlate::hard, .1, 0.004272842241, 0.04788638, 0.04788638, 0.0009014613391, 5.02060768e-05,
     0, 0, 0.337657, 0},
    {SquarePlate::hard, .01, 0.004064457556, 0.04788638, 0.04788638, 0.0008517573231,
     5.02060768e-07, 0, 0, 0.337657, 0},
    {SquarePlate::hard, .001, 0.00406237371, 0.04788638, 0.04788638, 0.0008512602829,
     5.02060768e-09, 0, 0, 0.337657, 0},
    {SquarePlate::clamped, .1, 0.001504625668, 0.023199869, 0.023199869, 0.0002502212267,
     5.40824123e-05, 0, -0.0148109, 0.412191, 0},
    {SquarePlate::clamped, .01, 0.001267858562, 0.022909449, 0.022909449, 0.0001951467397,
     5.85283632e-07, 0, -0.0153932, 0.439224, 0},
    {SquarePlate::clamped, .001, 0.001265344594, 0.022905135, 0.022905135, 0.0001945659298,
     5.88981047e-09, 0, -0.0154001, 0.441104, 0},
    {SquarePlate::clamped_free, .1, 0.002915087923, 0.040586834, 0.010538646, 0.0008288166602, 0,
     0.00332868343, 0.0415329, 0.485694, 0.483964},
    {SquarePlate::clamped_free, .01, 0.002563190018, 0.040597158, 0.010903011, 0.0007073549506, 0,
     0.00291898153, 0.043236, 0.484086, 2.50274},
    {SquarePlate::clamped_free, .001, 0.002559770765, 0.040606193, 0.010932876, 0.0007057662424, 0,
     0.00290947995, 0.0434038, 0.484222, 22.6885},
    {SquarePlate::free, .1, 0, 0.0089826874, 0.0089826874, 3.706927112e-05, 0, -0.000576048136,
     -0.00873423, 0, -0.242865},
    {SquarePlate::free, .01, 0, 0.0088507291, 0.0088507291, 3.039903062e-05, 0, -0.000472073371,
     -0.0101189, 0, -1.74555},
    {SquarePlate::free, .001, 0, 0.0088366951, 0.0088366958, 3.011982959e-05, 0, -0.000467974788,
     -0.0102564, 0, -16.7257},
}};

}  // namespace anisofront::acceptance
