// Row 8 on the square: hard supports and q = sin pi x sin pi y (Navier): with S = k G t / D
//   w = (1 + 2 pi^2 / S) / (4 pi^4) s,  M_x = (1 + nu) / (4 pi^2) s,  s = sin pi x sin pi y,
//   Q_x = cos pi x sin pi y / (2 pi),  U = 1/2 int q w = w_c / 8.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "solver/space/reference_quadrature.hpp"
#include "tests/solver/acceptance/graded_mesh.hpp"
#include "tests/solver/acceptance/side_states.hpp"
#include "tests/solver/acceptance/square_plates.hpp"

using namespace anisofront;
using namespace anisofront::acceptance;
using std::numbers::pi;

namespace {

double wave(Point p) { return std::sin(pi * p.x) * std::sin(pi * p.y); }

PlateProblem navier_plate(double thickness) {
  PlateProblem problem = quarter_plate(SquarePlate::hard, thickness);
  problem.load = wave;
  return problem;
}

double centre_deflection(double thickness) {
  const double s = 3.5 / (thickness * thickness);
  return (1 + 2 * pi * pi / s) / (4 * std::pow(pi, 4));
}

constexpr double kMoment = 1.3 / (4 * pi * pi);

/// Largest error of M_x at the points of a rule of this degree, relative to the largest M_x.
double moment_error(const SolvedPlate& plate, int degree) {
  double largest = 0;
  for (Index e = 0; e < plate.fe.element_count(); ++e) {
    const Element element = element_at(plate.fe, e);
    for (const WeightedPoint& point : reference_quadrature(element.shape, degree)) {
      const PlateState state =
          plate_state(plate.fe, plate.problem, plate.solution, element, point.at);
      largest = std::max(largest, std::abs(state.moments.xx / kMoment - wave(state.x)));
    }
  }
  return largest;
}

void check_navier(const SolvedPlate& plate, double thickness) {
  CAPTURE(thickness);
  const double w = centre_deflection(thickness);
  const PlateState centre = state_at(plate, {0.5, 0.5});
  CHECK(relative_error(centre.w, w) <= 1e-6);
  CHECK(relative_error(4 * plate.solution.energy.total(), w / 8) <= 1e-6);
  // At vertices moments have order two only.
  CHECK(relative_error(centre.moments.xx, kMoment) <= 1.5e-3);
  CHECK(relative_error(SideStates(plate, test::kLeft).at({0, 0.5}).shear.x, 1 / (2 * pi)) <= 1e-3);
}

}  // namespace

TEST_SUITE("golden") {
  TEST_CASE("the sine load on hard supports gives Navier's solution") {
    const auto lines = equal_lines(32, 0.5);
    for (const double thickness : {.1, .01, .001}) {
      const SolvedPlate triangles(triangles_on(lines, lines), navier_plate(thickness));
      check_navier(triangles, thickness);
      CHECK(moment_error(triangles, 2) <= 1e-3);
      const SolvedPlate quads(quads_on(lines, lines), navier_plate(thickness));
      check_navier(quads, thickness);
      // On rectangles the 2 x 2 Gauss points are superconvergent.
      CHECK(moment_error(quads, 3) <= 1e-5);
    }
    check_navier(SolvedPlate(mixed_on(lines, lines), navier_plate(.01)), .01);
  }
}
