#include "solver/space/reference_quadrature.hpp"

#include <cmath>
#include <stdexcept>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

double integral(Shape shape, int degree, int i, int j) {
  double sum = 0;
  for (const auto& [at, weight] : reference_quadrature(shape, degree))
    sum += weight * std::pow(at.xi, i) * std::pow(at.eta, j);
  return sum;
}

double factorial(int n) { return std::tgamma(n + 1.); }

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("triangle rules integrate all monomials up to their degree") {
    for (int degree = 0; degree <= 12; ++degree)
      for (int i = 0; i <= degree; ++i)
        for (int j = 0; i + j <= degree; ++j)
          CHECK(integral(Shape::triangle, degree, i, j) ==
                doctest::Approx(factorial(i) * factorial(j) / factorial(i + j + 2)).epsilon(1e-12));
  }

  TEST_CASE("square rules integrate monomials up to their degree in each variable") {
    const auto side = [](int i) { return i % 2 ? 0. : 2. / (i + 1); };
    for (int degree = 0; degree <= 12; ++degree)
      for (int i = 0; i <= degree; ++i)
        for (int j = 0; j <= degree; ++j)
          CHECK(integral(Shape::quadrilateral, degree, i, j) ==
                doctest::Approx(side(i) * side(j)).epsilon(1e-12));
  }

  TEST_CASE("edge rules integrate monomials up to degree thirteen") {
    for (int degree = 0; degree <= 13; ++degree) {
      double sum = 0;
      for (const auto& [t, weight] : edge_quadrature(degree)) sum += weight * std::pow(t, degree);
      CHECK(sum == doctest::Approx(1. / (degree + 1)).epsilon(1e-13));
    }
  }

  TEST_CASE("the three-point rule has the known nodes") {
    const auto rule = edge_quadrature(5);
    REQUIRE(rule.size() == 3);
    CHECK(rule[0].t == doctest::Approx(0.5 - 0.5 * std::sqrt(0.6)));
    CHECK(rule[1].t == 0.5);
    CHECK(rule[1].weight == doctest::Approx(4. / 9));
  }

  TEST_CASE("degrees without a reference rule are refused") {
    CHECK_THROWS_AS(reference_quadrature(Shape::triangle, 13), std::out_of_range);
    CHECK_THROWS_AS(reference_quadrature(Shape::quadrilateral, -1), std::out_of_range);
    CHECK_THROWS_AS(edge_quadrature(14), std::out_of_range);
  }
}
