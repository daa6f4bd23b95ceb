#include "solver/space/quadrature.hpp"

#include <cmath>
#include <stdexcept>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

double factorial(int n) { return std::tgamma(n + 1.); }

double sum_of_monomial(int degree, int i, int j) {
  double sum = 0;
  for (const auto& [l, weight] : triangle_quadrature(degree))
    sum += weight * std::pow(l[0], i) * std::pow(l[1], j);
  return sum;
}

/// Mean of l0^i l1^j over a triangle: 2 i! j! / (i + j + 2)! (beta integral).
double mean_of_monomial(int i, int j) {
  return 2 * factorial(i) * factorial(j) / factorial(i + j + 2);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("every triangle rule integrates all monomials of its degree exactly") {
    for (int degree = 0; degree <= kMaxQuadratureDegree; ++degree)
      for (int i = 0; i <= degree; ++i)
        for (int j = 0; i + j <= degree; ++j) {
          CAPTURE(degree);
          CAPTURE(i);
          CAPTURE(j);
          CHECK(std::abs(sum_of_monomial(degree, i, j) - mean_of_monomial(i, j)) < 4e-16);
        }
  }

  TEST_CASE("tabulated triangle rules are not exact one degree higher") {
    for (const int degree : {1, 2, 4, 6, 8, 12}) {
      double worst = 0;
      for (int i = 0; i <= degree + 1; ++i)
        worst = std::max(worst, std::abs(sum_of_monomial(degree, i, degree + 1 - i) -
                                         mean_of_monomial(i, degree + 1 - i)));
      CAPTURE(degree);
      CHECK(worst > 1e-9);
    }
  }

  TEST_CASE("triangle rules have positive weights and points inside") {
    for (int degree = 0; degree <= kMaxQuadratureDegree; ++degree)
      for (const auto& [l, weight] : triangle_quadrature(degree)) {
        CHECK(weight > 0);
        for (const double coordinate : l) CHECK(coordinate > 0);
        CHECK(l[0] + l[1] + l[2] == doctest::Approx(1).epsilon(1e-15));
      }
  }

  TEST_CASE("triangle rules have the least known number of points") {
    const int points[] = {1, 1, 3, 6, 6, 12, 12, 16, 16, 33, 33, 33, 33};
    for (int degree = 0; degree <= kMaxQuadratureDegree; ++degree)
      CHECK(triangle_quadrature(degree).size() == points[degree]);
  }

  TEST_CASE("degrees without a rule are refused") {
    CHECK_THROWS_AS(triangle_quadrature(-1), std::out_of_range);
    CHECK_THROWS_AS(triangle_quadrature(13), std::out_of_range);
  }
}
