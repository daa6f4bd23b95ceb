#include "solver/scalar/exact_solutions.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"

using namespace anisofront;

namespace {

/// -a Lap u + b . grad u + c u by fourth-order differences with step h.
double residual_source(const ExactSolution& exact, double a, double c, Vector b, Point p,
                       double h) {
  double sum = c * exact.value(p);
  for (const Vector d : {Vector{1, 0}, {0, 1}}) {
    const auto u = [&](double s) { return exact.value(p + s * h * d); };
    sum -= a * (-u(2) + 16 * u(1) - 30 * u(0) + 16 * u(-1) - u(-2)) / (12 * h * h);
    sum += dot(b, d) * (-u(2) + 8 * u(1) - 8 * u(-1) + u(-2)) / (12 * h);
  }
  return sum;
}

void check_consistency(const ExactSolution& exact, double a, double c, Point p, double h,
                       Vector b = {}) {
  CAPTURE(p.x);
  CAPTURE(p.y);
  CHECK(exact.source(p) ==
        doctest::Approx(residual_source(exact, a, c, b, p, h)).epsilon(1e-5).scale(1));
  const auto slope = [&](Vector d) {
    return (exact.value(p + h * d) - exact.value(p - h * d)) / (2 * h);
  };
  CHECK(exact.gradient(p).x == doctest::Approx(slope({1, 0})).epsilon(1e-5).scale(1));
  CHECK(exact.gradient(p).y == doctest::Approx(slope({0, 1})).epsilon(1e-5).scale(1));
}

constexpr Point kPlaces[] = {{0.5, 0.5}, {0.3, 0.8}, {0.02, 0.5}, {0.97, 0.015}};

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("source and gradient of the exact solutions agree with differences of the value") {
    for (const Point p : kPlaces) {
      check_consistency(product_layer(1e-4, 1), 1e-4, 1, p, 5e-5);
      check_consistency(product_layer(0.5, 2), 0.5, 2, p, 1e-3);
      check_consistency(sine_product(0.25, 3), 0.25, 3, p, 1e-3);
    }
  }

  TEST_CASE("layers of convection agree with differences of the value") {
    for (const Point p : kPlaces)
      for (const double c : {0., 2.}) {
        check_consistency(exponential_layer(0.1, c, 2), 0.1, c, p, 1e-4, {2, 0});
        check_consistency(parabolic_layers(0.1, c, 2), 0.1, c, p, 1e-4, {2, 0});
        check_consistency(parabolic_layers(0.01, c, 1), 0.01, c, p, 3e-5, {1, 0});
      }
  }

  TEST_CASE("the corner solution agrees with differences of the value on its three quadrants") {
    for (const Point p : {Point{0.5, 0.5}, {0.4, 0.01}, {-0.3, 0.8}, {-0.6, -0.01}, {-0.02, -0.4}})
      check_consistency(corner_singularity(2, 3), 2, 3, p, 1e-4);
    const ExactSolution exact = corner_singularity(1, 0);
    // Zero on the sides of the corner, and r^(2/3) where theta = 3 pi / 4.
    CHECK(std::abs(exact.value({0.7, 0})) < 1e-15);
    CHECK(std::abs(exact.value({0.7, -1e-18})) < 1e-15);
    CHECK(std::abs(exact.value({0, -0.7})) < 1e-15);
    CHECK(exact.value({-1, 1}) == doctest::Approx(std::cbrt(2)));
    CHECK(exact.value({0, 0}) == 0);
    CHECK(exact.gradient({0, 0}) == Vector{0, 0});
    CHECK(*corner_singularity(2, 0).squared_energy == doctest::Approx(2 * 1.836226661875162634));
    CHECK_FALSE(corner_singularity(1, 1).squared_energy.has_value());
  }

  TEST_CASE("fronts along a line and a circle agree with differences of the value") {
    const Front line{{0.4, 0.5}, 0.6, 0, 0.1}, circle{{0.1, 0.2}, 0, 0.5, 0.1};
    for (const Point p : kPlaces)
      for (const Front& front : {line, circle})
        check_consistency(internal_front(0.3, 2, front), 0.3, 2, p, 1e-4);
    const ExactSolution exact = internal_front(1, 0, circle);
    CHECK(std::abs(exact.value({0.6, 0.2})) < 1e-15);
    CHECK(exact.value({0.7, 0.2}) == doctest::Approx(std::tanh(1)));
    CHECK(exact.value({0.1, 0.2}) == doctest::Approx(std::tanh(-5)));
    CHECK(exact.gradient({0.1, 0.2}) == Vector{0, 0});
    CHECK(std::isfinite(exact.source({0.1, 0.2})));
    CHECK(
        internal_front(1, 0, line).value({0.4 - 0.1 * std::sin(0.6), 0.5 + 0.1 * std::cos(0.6)}) ==
        doctest::Approx(0).scale(1));
  }

  TEST_CASE("the layer solution is the ratio of hyperbolic cosines where that can be evaluated") {
    const double eps = 0.05;
    const auto g = [eps](double s) {
      return 1 - std::cosh((s - 0.5) / eps) / std::cosh(0.5 / eps);
    };
    const ExactSolution exact = product_layer(eps * eps, 1);
    const ExactSolution outflow = parabolic_layers(eps, 0, 1);
    const auto x = [eps](double s) {
      return s - (std::exp(s / eps) - 1) / (std::exp(1 / eps) - 1);
    };
    const auto y = [eps](double s) {
      return 1 - std::cosh((s - 0.5) / std::sqrt(eps)) / std::cosh(0.5 / std::sqrt(eps));
    };
    for (const Point p : {Point{0.1, 0.2}, {0.5, 0.03}, {0.9, 0.6}}) {
      CHECK(exact.value(p) == doctest::Approx(g(p.x) * g(p.y)).epsilon(1e-13));
      CHECK(outflow.value(p) == doctest::Approx(x(p.x) * y(p.y)).epsilon(1e-13));
    }
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
    const ExactSolution outflow = parabolic_layers(1e-8, 0, 1);
    CHECK(outflow.value({1, 0.5}) == 0);
    CHECK(outflow.value({0, 0.5}) == 0);
    CHECK(outflow.value({0.5, 1}) == 0);
    CHECK(outflow.value({0.5, 0.5}) == doctest::Approx(0.5));
    CHECK(outflow.value({1 - 1e-8, 0.5}) == doctest::Approx(1 - std::exp(-1)));
    CHECK(outflow.gradient({1, 0.5}).x == doctest::Approx(-1e8));
    CHECK(outflow.source({0.5, 0.5}) == doctest::Approx(1));
    const ExactSolution front = internal_front(1, 0, {{0.5, 0.5}, 0, 0, 1e-9});
    CHECK(front.value({0.6, 0}) == 1);
    CHECK(front.gradient({0.6, 0}) == Vector{0, 0});
    CHECK(front.gradient({0.5, 0}).x == doctest::Approx(1e9));
  }

  TEST_CASE("exact solutions are found by name and unknown names list the known ones") {
    CHECK(exact_solution("product-layer", 1e-4, 1).value({0.5, 0.5}) == doctest::Approx(1));
    CHECK(exact_solution("sine-product", 1, 0).value({0.5, 0.5}) == doctest::Approx(1));
    CHECK(exact_solution("corner-singularity", 1, 0).value({-1, 1}) ==
          doctest::Approx(std::cbrt(2)));
    CHECK_THROWS_WITH_AS(exact_solution("layer", 1, 1), doctest::Contains("product-layer"),
                         UsageError);
    for (const std::string& name : exact_solution_names())
      CHECK_THROWS_WITH_AS(exact_solution("", 1, 1), doctest::Contains(name.c_str()), UsageError);
  }

  TEST_CASE("parameters outside the preconditions of a named solution are refused") {
    CHECK_THROWS_AS(exact_solution("product-layer", 1, 0), UsageError);
    CHECK_THROWS_AS(exact_solution("sine-product", 0, 1), UsageError);
    CHECK_THROWS_AS(exact_solution("sine-product", 1, -1), UsageError);
    CHECK_THROWS_WITH_AS(exact_solution("exponential-layer", 1, 0), doctest::Contains("velocity"),
                         UsageError);
    ExactParameters parameters;
    parameters.velocity = {1, 0.5};
    CHECK_THROWS_AS(exact_solution("parabolic-layers", parameters), UsageError);
    CHECK_THROWS_WITH_AS(exact_solution("circle-front", parameters), doctest::Contains("radius"),
                         UsageError);
    parameters.front.radius = 0.3;
    CHECK_THROWS_AS(exact_solution("line-front", parameters), UsageError);
    parameters.front.width = 0;
    CHECK_THROWS_WITH_AS(exact_solution("circle-front", parameters), doctest::Contains("width"),
                         UsageError);
  }

  TEST_CASE("a velocity enters the source of every named solution") {
    ExactParameters parameters{0.3, 2, {1.5, -0.7}, {{0.3, 0.4}, 0.6, 0, 0.2}};
    for (const char* name : {"product-layer", "sine-product", "corner-singularity", "line-front"})
      check_consistency(exact_solution(name, parameters), 0.3, 2, {0.45, 0.35}, 1e-4,
                        parameters.velocity);
    parameters.velocity = {1.5, 0};
    for (const char* name : {"exponential-layer", "parabolic-layers"})
      check_consistency(exact_solution(name, parameters), 0.3, 2, {0.45, 0.35}, 1e-4,
                        parameters.velocity);
  }
}
