#include "mesher/geometry/convex_polygon.hpp"

#include <doctest/doctest.h>

TEST_SUITE("unit") {
  using namespace anisofront;

  TEST_CASE("a line cuts a square into the part on its left") {
    const std::vector<Point> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    const std::vector<Point> left = left_part(square, {1, 0}, {1, 2});  // upwards: x <= 1 stays
    REQUIRE(left.size() == 4);
    CHECK(left[0] == Point{0, 0});
    CHECK(left[1] == Point{1, 0});
    CHECK(left[2] == Point{1, 2});
    CHECK(left[3] == Point{0, 2});
  }

  TEST_CASE("a polygon wholly left of a line stays and one wholly right of it goes") {
    const std::vector<Point> triangle{{0, 0}, {1, 0}, {0, 1}};
    CHECK(left_part(triangle, {5, 0}, {5, 1}) == triangle);
    CHECK(left_part(triangle, {5, 1}, {5, 0}).empty());
  }

  TEST_CASE("the diagonal leaves a triangle") {
    const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const std::vector<Point> half{{0, 0}, {1, 1}, {0, 1}};
    CHECK(left_part(square, {0, 0}, {1, 1}) == half);
  }
}
