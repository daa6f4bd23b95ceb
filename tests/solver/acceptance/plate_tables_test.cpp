// The tables of FE.md 3.3: soft and hard supported, clamped, half free and free square plates at
// t = 0.1, 0.01, 0.001 on structured meshes graded to the edges and on the project's own adapted
// meshes, and row 14.
#include <algorithm>
#include <array>
#include <cmath>

#include <doctest/doctest.h>

#include "tests/solver/acceptance/layer_mesh.hpp"
#include "tests/solver/acceptance/reference_plate.hpp"
#include "tests/solver/acceptance/side_states.hpp"
#include "tests/solver/acceptance/square_plates.hpp"

using namespace anisofront;
using namespace anisofront::acceptance;

namespace {

struct Tolerances {
  double energy, deflection;
  double moment;      ///< relative to the larger one at the centre
  double edge_shear;  ///< Q in the layer, along the edge
};

/// A value relative to the reference, or to `scale` where that is 0.
void check_near(double value, double exact, double scale, double tolerance) {
  CAPTURE(value);
  CAPTURE(exact);
  CHECK(std::abs(value - exact) <= tolerance * (exact != 0 ? std::abs(exact) : scale));
}

/// What must hold whatever the mesh: loads (about 0.1 to 0.25 in all) and supports balance, and so
/// do work and energy, up to the round-off of the stiffness for t = 0.001.
void check_balance(const SolvedPlate& plate) {
  const PlateSolution& s = plate.solution;
  CHECK(relative_error(s.energy.total(), s.work) <= 1e-5);
  double supports = 0, amount = 0;
  for (const PlateReaction& reaction : s.reactions) {
    supports += reaction.force;
    amount += std::abs(reaction.force);
  }
  CHECK(std::abs(supports + s.load) <= 1e-6 * (amount + 0.1));
}

void check_table(const SolvedPlate& plate, const SquareReference& exact,
                 const Tolerances& tolerance) {
  const PlateState centre = state_at(plate, {0.5, 0.5}), edge = state_at(plate, {0.5, 0});
  const double w = std::max(std::abs(exact.w), std::abs(exact.edge_w));
  CHECK(relative_error(4 * plate.solution.energy.total(), exact.energy) <= tolerance.energy);
  check_near(centre.w, exact.w, w, tolerance.deflection);
  check_near(edge.w, exact.edge_w, w, tolerance.deflection);
  check_near(centre.moments.xx / exact.mx, 1, 1, tolerance.moment);
  check_near((centre.moments.yy - exact.my) / exact.mx, 0, 1, tolerance.moment);
  check_near((edge.moments.xx - exact.edge_mx) / exact.mx, 0, 1, tolerance.moment);
  check_near(SideStates(plate, test::kBottom).at({0.25, 0}).shear.x, exact.edge_s, 1e-9,
             tolerance.edge_shear);
  check_balance(plate);
}

/// Sizes that resolve the layer.
LayerSizes sizes_for(double thickness, double least, double growth) {
  LayerSizes sizes;
  sizes.least = least * plate_layer(thickness);
  sizes.growth = growth;
  sizes.most = 0.04;
  return sizes;
}

/// Largest shear force along the softly supported or free side y = 0.
double largest_edge_shear(const SolvedPlate& plate) {
  return largest_on_side(plate, test::kBottom, [](const PlateState& s) { return s.shear.x; });
}

struct LargestShear {
  SquarePlate plate;
  double thickness, value;
};
/// From references.json, max |Q_s| on an edge, where it is not at a singular corner.
constexpr std::array<LargestShear, 7> kLargestShear{{{SquarePlate::soft, .1, 0.948724},
                                                     {SquarePlate::soft, .01, 10.3693},
                                                     {SquarePlate::soft, .001, 103.265},
                                                     {SquarePlate::clamped_free, .1, 0.565973},
                                                     {SquarePlate::free, .1, 0.242865},
                                                     {SquarePlate::free, .01, 1.74766},
                                                     {SquarePlate::free, .001, 16.75066}}};

void check_largest_shear(const SolvedPlate& plate, const SquareReference& exact, double tolerance) {
  for (const LargestShear& largest : kLargestShear)
    if (largest.plate == exact.plate && largest.thickness == exact.thickness)
      CHECK(relative_error(largest_edge_shear(plate), largest.value) <= tolerance);
}

bool is_supported(SquarePlate plate) {
  return plate != SquarePlate::clamped_free && plate != SquarePlate::free;
}

void check_on_quads(const SquareReference& exact) {
  CAPTURE(name_of(exact.plate));
  CAPTURE(exact.thickness);
  const auto lines = size_lines(sizes_for(exact.thickness, 0.25, 0.3), 0.5);
  const SolvedPlate plate(quads_on(lines, lines), quarter_plate(exact.plate, exact.thickness));
  check_table(plate, exact, {3e-5, 2e-5, 6e-3, 4e-3});
  check_largest_shear(plate, exact, 1e-2);
  // Q across a soft edge is small beside that along it.
  const double normal = SideStates(plate, test::kLeft).at({0, 0.5}).shear.x;
  check_near(normal, exact.edge_q, 1, exact.plate == SquarePlate::soft ? 2e-2 : 2e-3);
  if (exact.shear_energy > 0)
    CHECK(relative_error(4 * plate.solution.energy.shear, exact.shear_energy) <= 1e-3);
}

void check_on_triangles(const SquareReference& exact) {
  CAPTURE(name_of(exact.plate));
  CAPTURE(exact.thickness);
  const auto lines = size_lines(sizes_for(exact.thickness, 0.25, 0.3), 0.5);
  const SolvedPlate plate(triangles_on(lines, lines), quarter_plate(exact.plate, exact.thickness));
  check_table(plate, exact, {1e-4, 1e-4, 4e-2, 2.5e-2});
  check_largest_shear(plate, exact, 3e-2);
}

void check_on_adapted_meshes(const SquareReference& exact) {
  CAPTURE(name_of(exact.plate));
  CAPTURE(exact.thickness);
  for (const Elements elements : {Elements::triangle, Elements::quadrilateral}) {
    CAPTURE(static_cast<int>(elements));
    const SolvedPlate plate(adapted_quarter(sizes_for(exact.thickness, 0.4, 0.35), elements),
                            quarter_plate(exact.plate, exact.thickness));
    check_table(plate, exact, {2e-4, 1e-4, 2e-2, 3e-2});
    check_largest_shear(plate, exact, 4e-2);
  }
}

/// The true error, against an overkill solution that has the energy of the table.
void check_energy_norm(const SquareReference& exact) {
  CAPTURE(name_of(exact.plate));
  CAPTURE(exact.thickness);
  const auto lines = layer_lines(32, 0.5, plate_layer(exact.thickness));
  const ReferencePlate reference(quarter_plate(exact.plate, exact.thickness), lines, lines);
  CHECK(relative_error(4 * reference.solution().energy.total(), exact.energy) <= 2e-6);
  for (const Elements elements : {Elements::triangle, Elements::quadrilateral}) {
    CAPTURE(static_cast<int>(elements));
    const SolvedPlate plate(adapted_quarter(sizes_for(exact.thickness, 0.5, 0.4), elements),
                            quarter_plate(exact.plate, exact.thickness));
    CHECK(relative_energy_error(plate, reference) <= 1e-2);
  }
}

}  // namespace

TEST_SUITE("golden") {
  TEST_CASE("quadrilaterals graded to the edges give the tables of square plates") {
    for (const SquareReference& exact : kSquareReferences) check_on_quads(exact);
  }

  TEST_CASE("triangles graded to the edges give the tables of square plates") {
    for (const SquareReference& exact : kSquareReferences)
      if (exact.thickness > .001) check_on_triangles(exact);
  }

  TEST_CASE("meshes of the project's own mesher give the tables of square plates") {
    for (const SquareReference& exact : kSquareReferences)
      if (exact.thickness > .001) check_on_adapted_meshes(exact);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("triangles and meshes of the project's own mesher give the tables for t = 0.001") {
    for (const SquareReference& exact : kSquareReferences) {
      if (exact.thickness > .001) continue;
      check_on_triangles(exact);
      check_on_adapted_meshes(exact);
    }
  }

  TEST_CASE("the error on meshes of the project's own mesher is below a percent in energy norm") {
    for (const SquareReference& exact : kSquareReferences)
      if (is_supported(exact.plate)) check_energy_norm(exact);
  }
}
