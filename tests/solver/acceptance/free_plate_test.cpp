// Row 14: a whole free plate under cos 2 pi x cos 2 pi y, held by three pins only.
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "tests/solver/acceptance/graded_mesh.hpp"
#include "tests/solver/acceptance/side_states.hpp"
#include "tests/solver/acceptance/square_plates.hpp"

using namespace anisofront;
using namespace anisofront::acceptance;

namespace {

/// Lines on [0, 1] thin at both ends.
std::vector<double> both_ends(const LayerSizes& sizes) {
  std::vector<double> lines = size_lines(sizes, 0.5);
  for (std::size_t i = lines.size() - 1; i > 0; --i) lines.push_back(1 - lines[i - 1]);
  return lines;
}

PlateProblem on_pins(double thickness, const std::vector<Point>& pins) {
  PlateProblem problem = quarter_plate(SquarePlate::free, thickness);
  problem.supports.clear();
  problem.point_supports.clear();
  for (const Point pin : pins) problem.point_supports.push_back({pin, 0, false});
  return problem;
}

/// Deflection relative to the plane that touches the centre.
double bent(const PlateState& state, const PlateState& centre) {
  return state.w - centre.w - dot(centre.rotation, state.x - centre.x);
}

}  // namespace

TEST_SUITE("golden") {
  TEST_CASE("a free plate on any three pins gives the references") {
    for (const SquareReference& exact : kSquareReferences) {
      if (exact.plate != SquarePlate::free) continue;
      CAPTURE(exact.thickness);
      LayerSizes sizes;
      sizes.least = 0.3 * plate_layer(exact.thickness);
      sizes.most = 0.05;
      const auto lines = both_ends(sizes);
      const SolvedPlate plate(quads_on(lines, lines),
                              on_pins(exact.thickness, {{0, 0}, {1, 0.5}, {0.5, 1}}));
      CHECK(relative_error(plate.solution.energy.total(), exact.energy) <= 1e-4);
      const PlateState centre = state_at(plate, {0.5, 0.5});
      for (const Point middle : {Point{0.5, 0}, Point{1, 0.5}, Point{0.5, 1}, Point{0, 0.5}})
        CHECK(relative_error(bent(state_at(plate, middle), centre), exact.edge_w) <= 1e-4);
      CHECK(relative_error(SideStates(plate, test::kBottom).at({0.25, 0}).shear.x, exact.edge_s) <=
            1e-2);
      // The loads balance each other, the pins carry nothing.
      REQUIRE(plate.solution.reactions.size() == 1);
      CHECK(plate.solution.reactions[0].largest <= 1e-7);
    }
  }
}
