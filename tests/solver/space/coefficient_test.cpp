#include "solver/space/coefficient.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"

using namespace anisofront;

TEST_SUITE("unit") {
  TEST_CASE("a coefficient is a number or a function") {
    CHECK(Coefficient(3.)({1, 2}) == 3);
    CHECK(Coefficient([](Point p) { return p.x - p.y; })({1, 3}) == -2);
    CHECK(Coefficient().is_zero());
    CHECK_FALSE(Coefficient([](Point) { return 0.; }).is_zero());
  }

  TEST_CASE("regions take their own value and the last one set holds") {
    RegionCoefficient a = 1.;
    a.set(7, 5.);
    a.set(7, 6.);
    CHECK(a.in(7)({0, 0}) == 6);
    CHECK(a.in(8)({0, 0}) == 1);
    CHECK(a.regions().size() == 1);
    RegionCoefficient zero;
    CHECK(zero.is_zero());
    zero.set(2, 1.);
    CHECK_FALSE(zero.is_zero());
  }

  TEST_CASE("values that are not finite are reported with name and place") {
    const Coefficient pole([](Point p) { return 1 / p.x; });
    CHECK(finite_value(pole, {2, 0}, "the load") == 0.5);
    CHECK_THROWS_WITH_AS(finite_value(pole, {0, 4}, "the load"),
                         doctest::Contains("the load is inf at (0.000000, 4.000000)"), InputError);
  }
}
