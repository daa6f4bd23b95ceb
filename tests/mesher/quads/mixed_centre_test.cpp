#include "mesher/quads/mixed_centre.hpp"

#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

#include "mesher/geometry/predicates.hpp"
#include "tests/support/domains.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// All corners of all parts of the face, each part written out.
bool parts_are_convex(const std::vector<Point>& corners, const std::vector<Point>& midpoints,
                      Point centre) {
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Point part[] = {corners[k], midpoints[k], centre, midpoints[(k + n - 1) % n]};
    for (int i = 0; i < 4; ++i)
      if (orientation(part[i], part[(i + 1) % 4], part[(i + 2) % 4]) <= 0) return false;
  }
  return true;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the centre of a square is that of its midpoints") {
    const std::vector<Point> corners{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    const auto centre =
        centre_of_division(corners, std::vector<Point>{{0.5, 0}, {2, 1}, {1, 2}, {0, 1}});
    REQUIRE(centre);
    CHECK(*centre == Point{0.875, 1});
  }

  TEST_CASE("a face with a flat or reflex corner has no centre") {
    const std::vector<Point> midpoints{{0.5, 0}, {0.75, 0.25}, {0.25, 0.75}, {0, 0.5}};
    CHECK_FALSE(
        centre_of_division(std::vector<Point>{{0, 0}, {1, 0}, {0.5, 0.5}, {0, 1}}, midpoints));
    CHECK_FALSE(
        centre_of_division(std::vector<Point>{{0, 0}, {1, 0}, {0.25, 0.25}, {0, 1}}, midpoints));
  }

  TEST_CASE("a corner that rounding alone keeps from being flat counts as flat") {
    // As three vertices on a straight side whose points are rounded.
    const Point corner{0.5, -1e-16};
    const std::vector<Point> corners{{0, 0}, corner, {1, 0}, {1, 1}, {0, 1}};
    const std::vector<Point> midpoints{{0.25, 0}, {0.75, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}};
    REQUIRE(orientation(midpoints[0], corner, midpoints[1]) > 0);
    CHECK_FALSE(centre_of_division(corners, midpoints));
  }

  TEST_CASE("where an edge bulges inwards the centre gives way") {
    const std::vector<Point> corners{{0, 0}, {4, 0}, {4, 1}, {0, 1}};
    const std::vector<Point> midpoints{{2, 0.7}, {4, 0.5}, {2, 1}, {0, 0.5}};
    REQUIRE_FALSE(parts_are_convex(corners, midpoints, mean_of(midpoints)));  // (2, 0.675)
    const auto centre = centre_of_division(corners, midpoints);
    REQUIRE(centre);
    CHECK(parts_are_convex(corners, midpoints, *centre));
  }

  TEST_CASE("where an edge bulges through the other side there is no centre") {
    CHECK_FALSE(centre_of_division(std::vector<Point>{{0, 0}, {4, 0}, {4, 1}, {0, 1}},
                                   std::vector<Point>{{2, 1.5}, {4, 0.5}, {2, 1}, {0, 0.5}}));
  }
}

TEST_SUITE("property") {
  TEST_CASE("convex faces are divided from the mean wherever the midpoints lie on their edges") {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int round = 0; round < 3000; ++round) {
      const int n = 3 + round % 3;
      std::vector<double> angles(n);
      for (double& phi : angles) phi = 2 * kPi * unit(random);
      std::sort(angles.begin(), angles.end());
      std::vector<Point> corners, midpoints;  // on an ellipse of axes 1 and up to 1000
      const double stretch = std::pow(1000, unit(random));
      for (const double phi : angles) corners.push_back({stretch * std::cos(phi), std::sin(phi)});
      bool convex = true;
      for (int k = 0; k < n; ++k) {
        midpoints.push_back(lerp(corners[k], corners[(k + 1) % n], 0.1 + 0.8 * unit(random)));
        const Vector u = corners[(k + 1) % n] - corners[k];
        convex &= squared_norm(u) > 1e-6 &&
                  twice_area(corners[k], corners[(k + 1) % n], corners[(k + 2) % n]) > 1e-6;
      }
      if (!convex) continue;
      const auto centre = centre_of_division(corners, midpoints);
      REQUIRE(centre);
      CHECK(*centre == mean_of(midpoints));
      CHECK(parts_are_convex(corners, midpoints, *centre));
    }
  }

  TEST_CASE("a centre that is found makes convex parts also where edges are curved") {
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> unit(-1, 1);
    int found = 0, moved = 0;
    for (int round = 0; round < 3000; ++round) {
      const std::vector<Point> corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
      std::vector<Point> midpoints;
      for (int k = 0; k < 4; ++k)
        midpoints.push_back(0.5 * (corners[k] + corners[(k + 1) % 4]) +
                            0.45 * Vector{unit(random), unit(random)});
      const auto centre = centre_of_division(corners, midpoints);
      if (!centre) continue;
      ++found;
      moved += *centre == mean_of(midpoints) ? 0 : 1;
      CHECK(parts_are_convex(corners, midpoints, *centre));
    }
    CHECK(found > 100);
    CHECK(moved > 10);
  }
}
