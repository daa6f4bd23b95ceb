// Row 19: the thinnest plates the solver takes are solved to the last digit.
#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/acceptance/reference_plate.hpp"
#include "tests/solver/acceptance/square_plates.hpp"

using namespace anisofront;
using namespace anisofront::acceptance;

TEST_SUITE("golden") {
  TEST_CASE("at a thickness of 1e-5 refinement takes the residual below 1e-10") {
    const auto lines = equal_lines(16, 0.5);
    for (const SquarePlate kind : {SquarePlate::clamped, SquarePlate::hard}) {
      CAPTURE(name_of(kind));
      for (const bool quads : {false, true}) {
        CAPTURE(quads);
        const SolvedPlate plate(quads ? quads_on(lines, lines) : triangles_on(lines, lines),
                                quarter_plate(kind, 1e-5));
        CHECK(plate.solution.linear.residual <= 1e-10);
        // Kirchhoff's plate: Timoshenko's tables extrapolated (references.json, "kirchhoff").
        const double kirchhoff =
            kind == SquarePlate::clamped ? 1.26531909e-3 : 4.062352660675051e-3;
        CHECK(relative_error(state_at(plate, {0.5, 0.5}).w, kirchhoff) <= 2e-3);
      }
    }
  }

  TEST_CASE("thinner plates than 1e-5 of the longer side are refused") {
    const auto lines = equal_lines(2, 0.5);
    const Mesh mesh = quads_on(lines, lines);
    const FeMesh space = straight_fe_mesh(mesh);
    CHECK_NOTHROW(solve_plate(space, quarter_plate(SquarePlate::hard, 5.1e-6)));
    CHECK_THROWS_AS(solve_plate(space, quarter_plate(SquarePlate::hard, 4.9e-6)), InputError);
  }
}
