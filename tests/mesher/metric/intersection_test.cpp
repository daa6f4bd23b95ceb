// Literals were computed with 40 digits (mpmath); optimality by brute force.
#include "mesher/metric/intersection.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "tests/mesher/metric/random_metric.hpp"

using namespace anisofront;
using doctest::Approx;

namespace {

const Metric kA{5, 2, 3}, kB{1, -0.5, 4}, kD{6, -3, 2};

void check_close(const Metric& found, const Metric& expected, double tolerance) {
  const double scale = expected.m11 + expected.m22;
  CHECK(std::fabs(found.m11 - expected.m11) <= tolerance * scale);
  CHECK(std::fabs(found.m12 - expected.m12) <= tolerance * scale);
  CHECK(std::fabs(found.m22 - expected.m22) <= tolerance * scale);
}

/// Squared length without the rounding of the evaluation.
long double exact_square(const Metric& m, Vector v) {
  const long double x = v.x, y = v.y;
  return m.m11 * x * x + 2 * m.m12 * x * y + m.m22 * y * y;
}

bool dominates(const Metric& m, const Metric& other) {
  for (int k = 0; k < 90; ++k) {
    const Vector v{std::cos(k * 0.0349), std::sin(k * 0.0349)};
    if (squared_length(m, v) < squared_length(other, v)) return false;
  }
  return true;
}

/// Least determinant of a metric that dominates both, by a search over its axes: for a fixed
/// direction and first size the second is the least that still dominates (found by bisection).
double least_determinant(const Metric& m1, const Metric& m2) {
  double best = 1e300;
  for (int i = 0; i < 90; ++i) {
    const double phi = 3.141592653589793 * i / 90;
    const Vector e{std::cos(phi), std::sin(phi)};
    for (int j = 0; j < 60; ++j) {
      const double h1 = 0.1 * std::pow(20, j / 59.);
      double low = 0.02, high = 5;
      if (!dominates(metric_from_sizes(h1, low, e), m1)) continue;
      if (!dominates(metric_from_sizes(h1, low, e), m2)) continue;
      for (int step = 0; step < 30; ++step) {
        const double h2 = 0.5 * (low + high);
        const Metric m = metric_from_sizes(h1, h2, e);
        (dominates(m, m1) && dominates(m, m2) ? low : high) = h2;
      }
      best = std::min(best, determinant(metric_from_sizes(h1, low, e)));
    }
  }
  return best;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("intersection of two metrics (Eqn 8)") {
    check_close(intersect(kA, kB), {5.1097921286437099, 1.5309727769012628, 5.0036640032875059},
                1e-14);
    check_close(intersect({1, 0, 100}, {100, 0, 1}), {100, 0, 100}, 1e-15);
  }

  TEST_CASE("a list is intersected in the given order") {
    const Metric forward[] = {kA, kB, kD}, backward[] = {kD, kB, kA};
    check_close(intersect(forward), {8.1319456585941207, -0.11603584215054019, 5.9012482472208171},
                1e-14);
    check_close(intersect(backward), {8.3068595517655752, -1.3605557938077838, 6.4151239466052938},
                1e-14);
    const Metric one[] = {kA};
    CHECK(intersect(one) == kA);
  }

  TEST_CASE("a metric that dominates the other is returned unchanged") {
    CHECK(intersect(kA, scaled(kA, 0.5)) == kA);
    CHECK(intersect(scaled(kA, 0.5), kA) == kA);
    CHECK(intersect(kA, {0.1, 0.03, 0.2}) == kA);
    CHECK(intersect(Metric{4, 0, 4}, Metric{1, 0, 1}) == Metric{4, 0, 4});
    check_close(intersect(kA, kA), kA, 1e-15);
  }

  TEST_CASE("no ellipse inside both is larger") {
    for (const auto& [m1, m2] : {std::pair{kA, kB}, std::pair{kA, kD}, std::pair{kB, kD}}) {
      const double searched = least_determinant(m1, m2);
      CHECK(determinant(intersect(m1, m2)) <= searched * 1.005);  // the search samples directions
      CHECK(determinant(intersect(m1, m2)) >= searched * 0.97);
    }
  }
}

TEST_SUITE("property") {
  TEST_CASE("the intersection contains both metrics to rounding") {
    std::mt19937_64 random(31);
    for (int i = 0; i < 4000; ++i) {
      const double max_stretch = i % 2 == 0 ? 30 : 1000;
      const Metric m1 = random_metric(random, max_stretch), m2 = random_metric(random, max_stretch);
      const Metric m = intersect(m1, m2);
      const double stretch = stretch_of(m);
      const double tolerance = 1e-12 + 4e-16 * stretch * stretch;
      const PrincipalAxes axes[] = {principal_axes(m1), principal_axes(m2), principal_axes(m)};
      for (int k = 0; k < 30; ++k) {
        const Vector v = k < 6 ? (k % 2 ? axes[k / 2].e1 : axes[k / 2].e2) : random_point(random);
        const long double needed = std::max(exact_square(m1, v), exact_square(m2, v));
        CHECK(exact_square(m, v) >= needed * (1 - tolerance));
      }
    }
  }

  TEST_CASE("the intersection does not depend on the order of two metrics") {
    std::mt19937_64 random(32);
    for (int i = 0; i < 3000; ++i) {
      const Metric m1 = random_metric(random, 1000), m2 = random_metric(random, 1000);
      check_close(intersect(m1, m2), intersect(m2, m1), 1e-11);
    }
  }
}
