// Literals: by hand where a comment says so, else mpmath with 40 digits on the triangle mapped to
// the normalised space by M^(1/2) (Heron's formula), which is not how the code computes them.
#include "mesher/metric/quality.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/mesher/metric/random_metric.hpp"

using namespace anisofront;
using doctest::Approx;

namespace {

const Metric kA{5, 2, 3}, kB{1, -0.5, 4}, kC{0.5, 0.2, 0.3}, kI{};
constexpr Point kP1{0, 0}, kP2{2, 0.5}, kP3{0.7, 1.9}, kP4{-1, 1.2};

double alpha_in(const Metric& m, Point a, Point b, Point c) { return alpha(factor_of(m), a, b, c); }

double euclidean_beta(Point a, Point b, Point c, Point d) {
  return beta(std::array{kI, kI, kI, kI}, std::array{a, b, c, d});
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("alpha of simple triangles in the Euclidean metric") {
    CHECK(alpha_in(kI, {0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}) == Approx(1).epsilon(1e-15));
    CHECK(alpha_in(kI, {0, 0}, {1, 0}, {0, 1}) == Approx(std::sqrt(3.) / 2).epsilon(1e-15));
    CHECK(alpha_in(kI, {0, 0}, {0, 1}, {1, 0}) == Approx(-std::sqrt(3.) / 2).epsilon(1e-15));
    CHECK(alpha_in(kI, {0, 0}, {1, 1}, {3, 3}) == 0);
    CHECK(alpha_in(kI, {2, 3}, {2, 3}, {2, 3}) == 0);
  }

  TEST_CASE("alpha in a metric is that of the triangle in normalised space (Eqn 15b)") {
    CHECK(alpha_in(kA, kP1, kP2, kP3) == Approx(0.78645798137127773).epsilon(1e-14));
    CHECK(alpha_in(kB, kP1, kP2, kP3) == Approx(0.79942326656728233).epsilon(1e-14));
    // size 1 along x, 1/100 along y: this flat triangle is equilateral
    CHECK(alpha_in({1, 0, 1e4}, {0, 0}, {1, 0}, {0.5, 0.01 * std::sqrt(0.75)}) ==
          Approx(1).epsilon(1e-14));
  }

  TEST_CASE("alpha does not change when the metric is scaled") {
    CHECK(alpha_in(scaled(kA, 4), kP1, kP2, kP3) ==
          Approx(alpha_in(kA, kP1, kP2, kP3)).epsilon(1e-15));
  }

  TEST_CASE("alpha of a triangle is the least over its vertices (Eqn 15a)") {
    CHECK(alpha(std::array{kA, kB, kC}, std::array{kP1, kP2, kP3}) ==
          Approx(0.78645798137127773).epsilon(1e-14));
    const double least = alpha_in({1, 0, 1e4}, kP1, kP2, kP3);
    CHECK(least < 0.1);
    CHECK(alpha(std::array{kI, Metric{1, 0, 1e4}, kI}, std::array{kP1, kP2, kP3}) == least);
  }

  TEST_CASE("beta of simple quadrilaterals") {
    CHECK(euclidean_beta({0, 0}, {1, 0}, {1, 1}, {0, 1}) == Approx(1).epsilon(1e-14));
    CHECK(euclidean_beta({0, 0}, {10, 0}, {10, 1}, {0, 1}) == Approx(1).epsilon(1e-14));
    const double s = std::sqrt(0.75);  // rhombus of 60 degrees: (3/5)^2
    CHECK(euclidean_beta({0, 0}, {1, 0}, {1.5, s}, {0.5, s}) == Approx(0.36).epsilon(1e-14));
    CHECK(euclidean_beta({0, 0}, {1, 0}, {0.5, 0.5}, {0, 1}) == -1);  // flat corner
    CHECK(euclidean_beta({0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}) == -1);  // concave
    CHECK(euclidean_beta({0, 0}, {0, 1}, {1, 1}, {1, 0}) == -1);      // clockwise
    CHECK(euclidean_beta({0, 0}, {1, 1}, {1, 0}, {0, 1}) == -1);      // crossing
  }

  TEST_CASE("beta with four metrics (Eqns 16a and 16b)") {
    // alphas 0.4948 0.5745 0.7187 0.7865
    CHECK(beta(std::array{kA, kB, kC, kI}, std::array{kP1, kP2, kP3, kP4}) ==
          Approx(0.50284007123105822).epsilon(1e-14));
  }

  TEST_CASE("mu is alpha or beta damped by the deviation of the lengths (Eqns 17a and 17b)") {
    const double lengths[] = {1, 0.5, 2};
    CHECK(mu(0.8, lengths) == Approx(0.8 * std::exp(-0.5)).epsilon(1e-15));
    CHECK(mu(std::array{kA, kB, kC}, std::array{kP1, kP2, kP3}) ==
          Approx(0.1287039708265239).epsilon(1e-14));
    CHECK(mu(std::array{kA, kB, kC, kI}, std::array{kP1, kP2, kP3, kP4}) ==
          Approx(0.14142241876452836).epsilon(1e-14));
  }

  TEST_CASE("the equilateral triangle of length two has mu 1/e as the paper quotes") {
    CHECK(
        mu(std::array{kI, kI, kI}, std::array<Point, 3>{Point{0, 0}, {2, 0}, {1, std::sqrt(3.)}}) ==
        Approx(0.36787944117144233).epsilon(1e-14));
    CHECK(
        mu(std::array{kI, kI, kI, kI}, std::array<Point, 4>{Point{0, 0}, {2, 0}, {2, 2}, {0, 2}}) ==
        Approx(0.36787944117144233).epsilon(1e-14));
  }
}

TEST_SUITE("property") {
  TEST_CASE("qualities do not depend on where the traversal of an element begins") {
    std::mt19937_64 random(51);
    for (int i = 0; i < 2000; ++i) {
      std::array<Metric, 4> m;
      std::array<Point, 4> p{Point{0, 0}, {1, 0}, {1, 1}, {0, 1}};
      for (Metric& metric : m) metric = random_metric(random, 10);
      for (Point& point : p) point = point + 0.3 * random_point(random);
      const std::array m2{m[1], m[2], m[3], m[0]};
      const std::array p2{p[1], p[2], p[3], p[0]};
      CHECK(beta(m2, p2) == Approx(beta(m, p)).epsilon(1e-10));
      CHECK(mu(m2, p2) == Approx(mu(m, p)).epsilon(1e-10));
    }
  }

  TEST_CASE("the image of the equilateral triangle under a size tensor has alpha 1") {
    std::mt19937_64 random(52);
    for (int i = 0; i < 2000; ++i) {
      const Metric m = random_metric(random, 1000);
      const SizeTensor h = size_of(m);
      const Point a = random_point(random);
      const Point b = a + h * Vector{1, 0}, c = a + h * Vector{0.5, std::sqrt(0.75)};
      CHECK(alpha_in(m, a, b, c) == Approx(1).epsilon(1e-8));
      CHECK(alpha_in(m, a, b, random_point(random)) <= 1 + 1e-9);
    }
  }
}
