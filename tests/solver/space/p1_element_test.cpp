#include "solver/space/p1_element.hpp"

#include <doctest/doctest.h>

using namespace anisofront;

TEST_SUITE("unit") {
  TEST_CASE("the linear triangle knows its area and the gradient of a linear function") {
    const std::array<Point, 3> corners{{{1, 2}, {4, 3}, {2, 7}}};
    const P1Element element(corners);
    CHECK(element.area == doctest::Approx(7));  // (3 * 5 - 1 * 1) / 2
    // 5 - 3x + 2y at the corners.
    const Vector g = element.gradient({6, -1, 13});
    CHECK(g.x == doctest::Approx(-3));
    CHECK(g.y == doctest::Approx(2));
  }

  TEST_CASE("gradients stay accurate on a triangle stretched by a million") {
    const P1Element element({{{0, 0}, {1, 0}, {0.3, 1e-6}}});
    const Vector g = element.gradient({0, 2, 0.6 + 5e-6});  // 2x + 5y
    CHECK(g.x == doctest::Approx(2).epsilon(1e-12));
    CHECK(g.y == doctest::Approx(5).epsilon(1e-9));
  }
}
