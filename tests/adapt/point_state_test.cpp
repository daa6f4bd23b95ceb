#include "adapt/point_state.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/adapt/flux_data.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;

TEST_SUITE_BEGIN("unit");

TEST_CASE("the state of a scalar solution is its value and gradient") {
  const Mesh mesh = perturbed_mesh(5, 0.2, 7);
  const FeMesh fe = straight_fe_mesh(mesh);
  const auto plane = [](Point p) { return 1 + 3 * p.x - 2 * p.y; };
  const auto solution = std::make_shared<ScalarSolution>();
  solution->field = interpolant(fe, 1, plane);
  const PointState state = scalar_point_state(fe, solution);
  PointLocation location(fe);
  const std::vector<double> found = state.at(location.nearest({0.3, 0.4}));
  CHECK(state.quantities.at_point == std::vector<std::string>{"u", "u_x", "u_y"});
  REQUIRE(found.size() == 3);
  CHECK(found[0] == doctest::Approx(1.1));
  CHECK(found[1] == doctest::Approx(3));
  CHECK(found[2] == doctest::Approx(-2));
}

TEST_CASE("along a line the gradient has a part to the right of it and one along it") {
  const Quantities scalar = scalar_quantities();
  CHECK(scalar.along_line == std::vector<std::string>{"u_n", "u_s"});
  CHECK(scalar.along({9, 3, -2}, {1, 0}) == std::vector<double>{2, 3});   // n points down
  CHECK(scalar.along({9, 3, -2}, {0, 1}) == std::vector<double>{3, -2});  // n points right
}

TEST_CASE("along a line moments and shear forces are those of its normal and tangent") {
  const Quantities plate = plate_quantities();
  const std::vector<double> state{0, 0, 0, 1, 2, 3, 4, 5};  // M = (1, 2, 3), Q = (4, 5)
  CHECK(plate.along_line == std::vector<std::string>{"M_n", "M_s", "M_ns", "Q_n", "Q_s"});
  CHECK(plate.along(state, {0, 1}) == std::vector<double>{1, 2, 3, 4, 5});
  CHECK(plate.along(state, {1, 0}) == std::vector<double>{2, 1, -3, -5, 4});
  // Along the bisector the principal values of M + its twist: trace and determinant stay.
  const std::vector<double> oblique = plate.along(state, {std::sqrt(0.5), std::sqrt(0.5)});
  CHECK(oblique[0] + oblique[1] == doctest::Approx(3));
  CHECK(oblique[0] * oblique[1] - oblique[2] * oblique[2] == doctest::Approx(2 - 9));
  CHECK(oblique[1] == doctest::Approx(0.5 * (1 + 2) + 3));
  CHECK(oblique[3] == doctest::Approx((4 - 5) * std::sqrt(0.5)));
  CHECK(oblique[4] == doctest::Approx((4 + 5) * std::sqrt(0.5)));
}

TEST_CASE("the state of a plate outlives what it was made from") {
  const Mesh mesh = square_mesh(6);
  const FeMesh fe = straight_fe_mesh(mesh);
  PlateProblem problem = plate(unit_bending(0.1), 1.);
  support_all_sides(SupportKind::clamped, problem);
  PointLocation location(fe);
  const Location centre = location.nearest({0.5, 0.5});
  PointState state;
  std::vector<double> expected;
  {
    const auto shared = std::make_shared<const PlateProblem>(problem);
    const auto solution = std::make_shared<const PlateSolution>(solve_plate(fe, problem));
    state = plate_point_state(fe, shared, solution);
    const PlateState s = plate_state(fe, problem, *solution, centre.element, centre.at);
    expected = {s.w,          s.rotation.x, s.rotation.y, s.moments.xx,
                s.moments.yy, s.moments.xy, s.shear.x,    s.shear.y};
  }
  CHECK(state.at(centre) == expected);
  CHECK(state.quantities.at_point.size() == expected.size());
}

TEST_SUITE_END();
