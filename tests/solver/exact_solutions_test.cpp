#include "solver/exact_solutions.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"

using namespace anisofront;

namespace {

/// -a Lap u + c u by fourth-order differences with step h.
double residual_source(const ExactSolution& exact, double a, double c, Point p, double h) {
  const auto second = [&](Vector d) {
    const auto u = [&](double s) { return exact.value(p + s * h * d); };
    return (-u(2) + 16 * u(1) - 30 * u(0) + 16 * u(-1) - u(-2)) / (12 * h * h);
  };
  return -a * (second({1, 0}) + second({0, 1})) + c * exact.value(p);
}

void check_consistency(const ExactSolution& exact, double a, double c, Point p, double h) {
  CAPTURE(p.x);
  CAPTURE(p.y);
  CHECK(exact.source(p) == doctest::Approx(residual_source(exact, a, c, p, h)).epsilon(1e-5));
  const auto slope = [&](Vector d) {
    return (exact.value(p + h * d) - exact.value(p - h * d)) / (2 * h);
  };
  CHECK(exact.gradient(p).x == doctest::Approx(slope({1, 0})).epsilon(1e-5).scale(1));
  CHECK(exact.gradient(p).y == doctest::Approx(slope({0, 1})).epsilon(1e-5).scale(1));
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("source and gradient of the exact solutions agree with differences of the value") {
    for (const Point p : {Point{0.5, 0.5}, {0.3, 0.8}, {0.02, 0.5}, {0.97, 0.015}}) {
      check_consistency(product_layer(1e-4, 1), 1e-4, 1, p, 5e-5);
      check_consistency(product_layer(0.5, 2), 0.5, 2, p, 1e-3);
      check_consistency(sine_product(0.25, 3), 0.25, 3, p, 1e-3);
    }
  }

  TEST_CASE("the layer solution is the ratio of hyperbolic cosines where that can be evaluated") {
    const double eps = 0.05;
    const auto g = [eps](double s) {
      return 1 - std::cosh((s - 0.5) / eps) / std::cosh(0.5 / eps);
    };
    const ExactSolution exact = product_layer(eps * eps, 1);
    for (const Point p : {Point{0.1, 0.2}, {0.5, 0.03}, {0.9, 0.6}})
      CHECK(exact.value(p) == doctest::Approx(g(p.x) * g(p.y)).epsilon(1e-13));
  }

  TEST_CASE("the layer energies are the reference values") {
    // FE.md 3.1: eps = .01 gives 0.9603 and eps = .001 gives 0.996003.
    CHECK(*product_layer(1e-4, 1).squared_energy == doctest::Approx(0.9603).epsilon(1e-12));
    CHECK(*product_layer(1e-6, 1).squared_energy == doctest::Approx(0.996003).epsilon(1e-12));
    CHECK(*product_layer(2e-4, 2).squared_energy == doctest::Approx(2 * 0.9603).epsilon(1e-12));
    CHECK(*sine_product(1, 0).squared_energy == doctest::Approx(4.934802200544679));  // pi^2 / 2
  }

  TEST_CASE("very thin layers neither overflow nor miss the boundary value") {
    const ExactSolution exact = product_layer(1e-12, 1);
    CHECK(exact.value({0, 0.3}) == 0);
    CHECK(exact.value({0.4, 1}) == 0);
    CHECK(exact.value({0.5, 0.5}) == 1);
    CHECK(exact.gradient({0, 0.5}).x == doctest::Approx(1e6));
    CHECK(exact.value({1e-6, 0.5}) == doctest::Approx(1 - std::exp(-1)));
    CHECK(std::isfinite(exact.source({1e-9, 1e-9})));
  }

  TEST_CASE("exact solutions are found by name and unknown names list the known ones") {
    CHECK(exact_solution("product-layer", 1e-4, 1).value({0.5, 0.5}) == doctest::Approx(1));
    CHECK(exact_solution("sine-product", 1, 0).value({0.5, 0.5}) == doctest::Approx(1));
    CHECK_THROWS_WITH_AS(exact_solution("layer", 1, 1), doctest::Contains("product-layer"),
                         UsageError);
    CHECK_THROWS_AS(exact_solution("product-layer", 1, 0), UsageError);
    CHECK_THROWS_AS(exact_solution("sine-product", 0, 1), UsageError);
  }
}
