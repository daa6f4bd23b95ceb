// Literals were computed with 40 digits (mpmath, eigenvectors of M = [[5, 2], [2, 3]]) or by hand.
#include "mesher/metric/metric.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "tests/mesher/metric/random_metric.hpp"

using namespace anisofront;
using doctest::Approx;

namespace {

constexpr double kPi = 3.141592653589793;
const Metric kMetric{5, 2, 3};

Approx close(double value, double epsilon = 4e-15) { return Approx(value).epsilon(epsilon); }

/// Largest entry of the difference relative to the largest entry of `a`.
double relative_difference(const Metric& a, const Metric& b) {
  const double difference =
      std::max({std::fabs(a.m11 - b.m11), std::fabs(a.m12 - b.m12), std::fabs(a.m22 - b.m22)});
  return difference / std::max(a.m11, a.m22);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("lengths in a constant metric follow Eqn 10a") {
    CHECK(squared_length(kMetric, {1, -2}) == 9);  // 5 - 2*2*2 + 3*4
    CHECK(length(kMetric, {1, -2}) == 3);
    CHECK(squared_length(factor_of(kMetric), {1, -2}) == close(9));
    CHECK(length(kMetric, {0, 0}) == 0);
    CHECK(determinant(kMetric) == 11);
    CHECK(inner_product(kMetric, {1, 0}, {0, 1}) == 2);
  }

  TEST_CASE("principal axes are the eigenpairs of Eqn 2b") {
    const PrincipalAxes axes = principal_axes(kMetric);  // eigenvalues 4 + sqrt 5 and 4 - sqrt 5
    CHECK(axes.h1 == close(0.40044657145607853));
    CHECK(axes.h2 == close(0.75293776016467594));
    CHECK(axes.e1.x == close(0.85065080835203993));
    CHECK(axes.e1.y == close(0.52573111211913361));
    CHECK(axes.e2 == Vector{-axes.e1.y, axes.e1.x});
    CHECK(stretch_of(kMetric) == close(1.8802452407742966));
  }

  TEST_CASE("principal axes of diagonal and isotropic metrics") {
    const PrincipalAxes wide = principal_axes({1, 0, 100});
    CHECK(wide.h1 == 0.1);
    CHECK(wide.h2 == 1);
    CHECK(std::fabs(wide.e1.y) == 1);
    CHECK(wide.e1.x == 0);
    const PrincipalAxes round = principal_axes({4, 0, 4});
    CHECK(round.h1 == 0.5);
    CHECK(round.h2 == 0.5);
    CHECK(round.e1 == Vector{1, 0});
    CHECK(round.e2 == Vector{0, 1});
  }

  TEST_CASE("a vector of size h_i along e_i has unit length (Eqn 3)") {
    const Metric m = metric_from_sizes(0.01, 3, {3, 4});  // the direction need not be normalised
    CHECK(length(m, {0.006, 0.008}) == close(1));
    CHECK(length(m, {-2.4, 1.8}) == close(1, 1e-10));
    CHECK(metric_from_size(0.5) == Metric{4, 0, 4});
    CHECK(scaled(kMetric, 0.25) == Metric{1.25, 0.5, 0.75});
  }

  TEST_CASE("square root and inverse square root follow Eqns 14a and 14b") {
    const Metric root = square_root(kMetric);
    CHECK(root.m11 == close(2.1740859955719691));
    CHECK(root.m12 == close(0.52282892408305038));
    CHECK(root.m22 == close(1.6512570714889187));
    const SizeTensor size = size_of(kMetric);
    CHECK(size.h11 == close(0.49787273986816422));
    CHECK(size.h12 == close(-0.15763885188442602));
    CHECK(size.h22 == close(0.65551159175259025));
  }

  TEST_CASE("angles are anticlockwise in the metric (Eqn 9)") {
    const double phi = std::acos(2 / std::sqrt(15.));  // du = (1,0), dv = (0,1): 2/(sqrt 5 sqrt 3)
    CHECK(angle(kMetric, {1, 0}, {0, 1}) == close(1.0281572245452439));
    CHECK(angle(kMetric, {0, 1}, {1, 0}) == close(2 * kPi - phi));
    CHECK(angle(kMetric, {1, 0}, {0, -7}) == close(kPi + phi));
    CHECK(angle(kMetric, {1, 0}, {-0.2, 0}) == close(kPi));
  }

  TEST_CASE("the angle of parallel or zero vectors is 0 and never 2 pi") {
    CHECK(angle(kMetric, {1, 2}, {3, 6}) == 0);
    CHECK(angle(kMetric, {1, 2}, {1, 2}) == 0);
    CHECK(angle(kMetric, {0, 0}, {1, 2}) == 0);
    CHECK(angle(kMetric, {1, 0}, {1, -1e-30}) == 0);
    CHECK(angle(kMetric, {1, 0}, {1, 1e-30}) < 1e-29);
  }

  TEST_CASE("rotation follows Eqn 13") {
    const Vector v = rotate(kMetric, {1, -2}, 0.7);
    CHECK(v.x == close(1.5417979516037421));
    CHECK(v.y == close(-1.3354454334891634));
    const Vector quarter = rotate({1, 0, 100}, {1, 0}, 0, 1);  // size 0.1 along y
    CHECK(quarter == Vector{0, 0.1});
  }

  TEST_CASE("positive definite means finite with positive eigenvalues") {
    CHECK(is_positive_definite(kMetric));
    CHECK(is_positive_definite({1e-20, 0, 1e20}));
    CHECK_FALSE(is_positive_definite({1, 2, 1}));
    CHECK_FALSE(is_positive_definite({1, 1, 1}));
    CHECK_FALSE(is_positive_definite({-1, 0, -1}));
    CHECK_FALSE(is_positive_definite({0, 0, 0}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    CHECK_FALSE(is_positive_definite({nan, 0, 1}));
    CHECK_FALSE(is_positive_definite({1, nan, 1}));
    CHECK_FALSE(is_positive_definite({1, 0, inf}));
  }
}

TEST_SUITE("property") {
  TEST_CASE("sizes and directions come back from the metric made of them") {
    std::mt19937_64 random(1);
    for (int i = 0; i < 2000; ++i) {
      const double phi = kPi * (i / 2000. - 0.5), stretch = 1 + i % 1000;
      const Metric m = metric_from_sizes(0.3, 0.3 * stretch, {std::cos(phi), std::sin(phi)});
      const PrincipalAxes axes = principal_axes(m);
      CHECK(axes.h1 == close(0.3, 1e-14));
      CHECK(axes.h2 == close(0.3 * stretch, 1e-15 * (10 + stretch * stretch)));
      if (stretch > 1.5) CHECK(std::fabs(cross(axes.e1, {std::cos(phi), std::sin(phi)})) < 1e-15);
    }
  }

  TEST_CASE("the size tensor gives the metric back at any stretch") {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 20000; ++i) {
      const double phi = 2 * kPi * unit(random), stretch = std::pow(1e4, unit(random));
      const Metric m = metric_from_sizes(1, stretch, {std::cos(phi), std::sin(phi)});
      CHECK(relative_difference(m, metric_of(size_of(m))) < 1e-15 * (1 + stretch));
    }
  }

  TEST_CASE("factors give the metric back") {
    std::mt19937_64 random(3);
    for (int i = 0; i < 2000; ++i) {
      const Metric m = random_metric(random, 1e4);
      CHECK(relative_difference(m, metric_of(factor_of(m))) < 1e-15);
      const Vector v = random_point(random);
      const Vector image = square_root(m) * v;  // Eqn 10b
      CHECK(norm(image) == close(length(m, v), 1e-8));
    }
  }

  TEST_CASE("rotation keeps the length and turns by the angle") {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 2000; ++i) {
      const Metric m = random_metric(random, 100);
      const Vector v = random_point(random);
      const double phi = 0.01 + 6.26 * unit(random);
      const Vector turned = rotate(m, v, phi);
      CHECK(length(m, turned) == close(length(m, v), 1e-10));
      CHECK(angle(m, v, turned) == close(phi, 1e-10));
    }
  }

  TEST_CASE("the angles of a triangle sum to pi in any metric") {
    std::mt19937_64 random(5);
    for (int i = 0; i < 2000; ++i) {
      const Metric m = random_metric(random, 1000);
      Point a = random_point(random), b = random_point(random);
      const Point c = random_point(random);
      if (twice_area(a, b, c) < 0) std::swap(a, b);
      const double sum = angle(m, b - a, c - a) + angle(m, c - b, a - b) + angle(m, a - c, b - c);
      CHECK(sum == close(kPi, 1e-8));
    }
  }
}
