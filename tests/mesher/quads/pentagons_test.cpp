#include "mesher/quads/pentagons.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/support/domains.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Deviation in degrees; `metric` is that at every vertex.
double deviation(const std::array<Point, 5>& points, const Metric& metric = {}) {
  std::array<WorkVertex, 5> pentagon;
  for (int k = 0; k < 5; ++k) pentagon[k] = {points[k], factor_of(metric), 0};
  return angle_deviation(pentagon) * 180 / kPi;
}

constexpr std::array<Point, 5> kEquilateralOnSquare{
    Point{0.5, 1.8660254037844386}, {0, 1}, {0, 0}, {1, 0}, {1, 1}};

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("an equilateral triangle on a square deviates by 150 degrees") {
    CHECK(deviation(kEquilateralOnSquare) == doctest::Approx(150));
  }

  TEST_CASE("the least deviation is 90 degrees") {
    CHECK(deviation({Point{0.5, 1.5}, {0, 1}, {0, 0}, {1, 0}, {1, 1}}) == doctest::Approx(90));
  }

  TEST_CASE("reflex angles count with their full size") {
    // 90 degrees at the apex (1, 1) and at (1, 0), 180 and then 270 at (0, 1).
    CHECK(deviation({Point{1, 1}, {0, 1}, {-1, 1}, {0, 0}, {1, 0}}) == doctest::Approx(90));
    CHECK(deviation({Point{1, 1}, {0, 1}, {0, 2}, {-1, 0}, {1, 0}}) == doctest::Approx(180));
  }

  TEST_CASE("angles are those of the metric") {
    // y is stretched by 10 and then x sheared: the picture of the equilateral case.
    std::array<Point, 5> points = kEquilateralOnSquare;
    for (Point& p : points) p = {p.x + 0.5 * 10 * p.y, 10 * p.y};
    // (x, y) -> (x - y / 2, y / 10) brings it back: M = T'T.
    CHECK(deviation(points, {1, -0.5, 0.25 + 0.01}) == doctest::Approx(150));
    CHECK(deviation(points) > 160);
  }

  TEST_CASE("corners at the nodes of the triangle are flat above 165 degrees") {
    // The corner in question lies at the origin, all others are below 130 degrees.
    const auto is_flat = [](double degrees, std::size_t corner) {
      const double phi = degrees * kPi / 180;
      const std::array<Point, 5> points{
          Point{0, 0}, {1, 0}, {1, 2}, {-1, 2}, {std::cos(phi), std::sin(phi)}};
      std::array<WorkVertex, 5> pentagon;
      for (std::size_t k = 0; k < 5; ++k)
        pentagon[(k + corner) % 5] = {points[k], factor_of(Metric{}), 0};
      return has_flat_corner(pentagon);
    };
    CHECK(is_flat(166, 0));
    CHECK_FALSE(is_flat(164, 0));
    CHECK(is_flat(166, 1));
    CHECK(is_flat(166, 4));
    CHECK_FALSE(is_flat(166, 2));
  }

  TEST_CASE("triangle and quadrilateral are joined without their common edge") {
    // The triangle 1 4 2 with edges 10 11 12, the square 0 1 2 3 with edges 13 12 14 15.
    const Cell triangle{3, {1, 4, 2}, {10, 11, 12}}, square{4, {0, 1, 2, 3}, {13, 12, 14, 15}};
    const Cell pentagon = join(triangle, 2, square, 1);
    CHECK(pentagon.size == 5);
    CHECK(pentagon.vertices == std::array<Index, 5>{4, 2, 3, 0, 1});
    CHECK(pentagon.edges == std::array<Index, 5>{11, 14, 15, 13, 10});
  }
}
