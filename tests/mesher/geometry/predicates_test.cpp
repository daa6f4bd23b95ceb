#include "mesher/geometry/predicates.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <doctest/doctest.h>

using namespace anisofront;

namespace {

int cgal_orientation(Point a, Point b, Point c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto convert = [](Point p) { return Kernel::Point_2(p.x, p.y); };
  return static_cast<int>(CGAL::orientation(convert(a), convert(b), convert(c)));
}

/// Moves a number by up to `most` units in the last place.
double nudge(double value, std::mt19937_64& random, int most = 2) {
  int steps = std::uniform_int_distribution<int>(-most, most)(random);
  for (; steps > 0; --steps) value = std::nextafter(value, 1e300);
  for (; steps < 0; ++steps) value = std::nextafter(value, -1e300);
  return value;
}

/// Number of triples that end in each sign, after comparison with CGAL and with the laws.
struct Tally {
  std::array<int, 3> signs{};
  int wrong = 0;
  int lawless = 0;

  void add(Point a, Point b, Point c) {
    const int sign = orientation(a, b, c);
    ++signs[static_cast<std::size_t>(sign + 1)];
    if (sign != cgal_orientation(a, b, c) || sign != detail::exact_orientation(a, b, c)) ++wrong;
    if (sign != orientation(b, c, a) || sign != -orientation(b, a, c)) ++lawless;
  }
};

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("orientation of plain triangles") {
    CHECK(orientation({0, 0}, {1, 0}, {0, 1}) == 1);
    CHECK(orientation({0, 0}, {0, 1}, {1, 0}) == -1);
    CHECK(orientation({0, 0}, {1, 1}, {3, 3}) == 0);
    CHECK(orientation({2, 5}, {2, 5}, {7, 1}) == 0);
  }

  TEST_CASE("orientation sees one unit in the last place where plain arithmetic does not") {
    const double eps = std::numeric_limits<double>::epsilon();
    const Point a{0.5, 0.5}, b{12, 12};
    CHECK(orientation(a, b, {24, 24 * (1 + eps)}) == 1);
    CHECK(orientation(a, b, {24 * (1 + eps), 24}) == -1);
    // 2^-60 below the line y = x through far points: lost in every difference of coordinates.
    const Point tiny{std::ldexp(1.0, -60), 0};
    CHECK(orientation({1, 1}, {-1, -1}, tiny) == 1);
    CHECK(orientation({-1, -1}, {1, 1}, tiny) == -1);
    CHECK(twice_area({-1, -1}, {1, 1}, tiny) == 0);
  }

  TEST_CASE("orientation is exact when all coordinate differences are exact") {
    // (2^27 + 1)^2 and (2^27)(2^27 + 2) differ by one in 2^54.
    const double n = std::ldexp(1.0, 27);
    CHECK(orientation({n + 1, n}, {n + 2, n + 1}, {0, 0}) == 1);
    CHECK(orientation({n + 2, n + 1}, {n + 1, n}, {0, 0}) == -1);
  }
}

TEST_SUITE("property") {
  TEST_CASE("orientation agrees with CGAL on random points and obeys its laws") {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto point = [&] { return Point{unit(random), unit(random)}; };
    Tally tally;
    for (int i = 0; i < 30000; ++i) tally.add(point(), point(), point());
    CHECK(tally.wrong == 0);
    CHECK(tally.lawless == 0);
  }

  TEST_CASE("orientation agrees with CGAL on points of a line moved by ulps") {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const double offset : {0.0, 1.0, 1e6, -3e12}) {
      Tally tally;
      for (int i = 0; i < 20000; ++i) {
        const Point a{offset + unit(random), offset + unit(random)};
        const Vector along{unit(random), unit(random)};
        const auto on_line = [&] {
          const Point p = a + 3 * unit(random) * along;
          return Point{nudge(p.x, random), nudge(p.y, random)};
        };
        tally.add(a, on_line(), on_line());
      }
      CAPTURE(offset);
      CHECK(tally.wrong == 0);
      CHECK(tally.lawless == 0);
      CHECK(tally.signs[0] > 100);
      CHECK(tally.signs[2] > 100);
    }
  }

  TEST_CASE("orientation agrees with CGAL on small lattices far from the origin") {
    std::mt19937_64 random(3);
    std::uniform_int_distribution<int> small(-3, 3);
    for (const double offset : {0.0, 0.1, 1e7, 1e15}) {
      const double step = std::nextafter(std::fabs(offset) + 1e-3, 1e300) - (offset + 1e-3);
      Tally tally;
      const auto point = [&] {
        return Point{offset + step * small(random), -offset + step * small(random)};
      };
      for (int i = 0; i < 20000; ++i) tally.add(point(), point(), point());
      CAPTURE(offset);
      CHECK(tally.wrong == 0);
      CHECK(tally.lawless == 0);
      CHECK(tally.signs[1] > 1000);
    }
  }

  TEST_CASE("orientation agrees with CGAL on points of very different size") {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::uniform_int_distribution<int> exponent(-60, 60);
    const auto number = [&] { return std::ldexp(unit(random), exponent(random)); };
    Tally tally;
    for (int i = 0; i < 30000; ++i) {
      const Point a{number(), number()}, b{number(), number()};
      const double s = unit(random);
      const Point near_line{nudge(a.x + s * (b.x - a.x), random),
                            nudge(a.y + s * (b.y - a.y), random)};
      tally.add(a, b, {number(), number()});
      tally.add(a, b, near_line);
    }
    CHECK(tally.wrong == 0);
    CHECK(tally.lawless == 0);
  }
}
