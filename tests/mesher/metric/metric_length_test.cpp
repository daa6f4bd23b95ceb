// Exact lengths by hand (integrals of 1/h) or by mpmath quadrature with 40 digits.
#include "mesher/metric/metric_length.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "tests/mesher/metric/random_metric.hpp"

using namespace anisofront;
using doctest::Approx;

namespace {

/// h = 1 + x: the length from x = 0 to x = 1 is ln 2.
Metric linear_size(Point p) { return metric_from_size(1 + p.x); }

/// Sizes 0.1 and 0.5 along axes that turn by one radian per unit of x.
Metric turning(Point p) { return metric_from_sizes(0.1, 0.5, {std::cos(p.x), std::sin(p.x)}); }

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a constant metric gives the exact length whatever the tolerance") {
    const auto metric = [](Point) { return Metric{5, 2, 3}; };
    for (const double tolerance : {10., 0.25, 0.01})
      CHECK(segment_length(metric, {1, 1}, {2, -1}, tolerance) == Approx(3).epsilon(1e-14));
  }

  TEST_CASE("the first division into two is always made") {
    int calls = 0;
    const auto counting = [&calls](Point) {
      ++calls;
      return Metric{};
    };
    CHECK(segment_length(counting, {0, 0}, {0.1, 0}) == Approx(0.1));
    CHECK(calls == 3);
    calls = 0;
    CHECK(segment_length(counting, {0, 0}, {1, 0}) ==
          Approx(1));  // 8 of 0.125: four are not < 0.25
    CHECK(calls == 9);
  }

  TEST_CASE("a coarse tolerance leaves the trapezoid rule of A12 on the two halves") {
    // densities 1, 2/3, 1/2 at x = 0, 1/2, 1: (1 + 2/3)/4 + (2/3 + 1/2)/4 = 17/24
    CHECK(segment_length(linear_size, {0, 0}, {1, 0}, 1) == Approx(17. / 24).epsilon(1e-15));
  }

  TEST_CASE("lengths converge to the integral with the square of the tolerance") {
    const double exact = std::log(2.);
    const double coarse = std::fabs(segment_length(linear_size, {0, 0}, {1, 0}, 0.05) - exact);
    const double fine = std::fabs(segment_length(linear_size, {0, 0}, {1, 0}, 0.0125) - exact);
    CHECK(coarse < 2.5e-4);  // (1/16)^2 / 12 times the change of the density's slope, 3/4
    CHECK(coarse > 1e-7);
    CHECK(fine < coarse / 12);  // sixteen in the limit
    CHECK(segment_length(turning, {0, 0}, {1, 0.3}) == Approx(9.8217111430776316).epsilon(1e-4));
    CHECK(segment_length(turning, {0, 0}, {1, 0.3}, 1e-3) ==
          Approx(9.8217111430776316).epsilon(1e-8));
  }

  TEST_CASE("a segment of no length has none") {
    CHECK(segment_length(turning, {2, 3}, {2, 3}) == 0);
    CHECK(metric_midpoint(turning, {2, 3}, {2, 3}) == 0.5);
  }

  TEST_CASE("a needle in the size is found once bisection comes near it") {
    const auto layer = [](Point p) { return metric_from_size(1e-3 + std::fabs(p.x - 0.5)); };
    const double exact = 2 * std::log(501.);  // both sides: ln((0.501)/(0.001))
    CHECK(segment_length(layer, {0, 0}, {1, 0}, 0.1) == Approx(exact).epsilon(1e-2));
  }

  TEST_CASE("at most 2^20 sub-segments are made") {
    std::int64_t calls = 0;
    const auto tiny = [&calls](Point) {
      ++calls;
      return metric_from_size(1e-9);
    };
    CHECK(segment_length(tiny, {0, 0}, {1, 0}) == Approx(1e9));
    CHECK(calls == (1 << 20) + 1);
  }

  TEST_CASE("the profile ascends from 0 to the length") {
    const SegmentProfile profile = segment_profile(linear_size, {0, 0}, {1, 0}, 0.05);
    REQUIRE(profile.t.size() == profile.length.size());
    CHECK(profile.t.front() == 0);
    CHECK(profile.length.front() == 0);
    CHECK(profile.t.back() == 1);
    CHECK(profile.length.back() == segment_length(linear_size, {0, 0}, {1, 0}, 0.05));
    CHECK(std::is_sorted(profile.t.begin(), profile.t.end()));
    for (std::size_t i = 1; i < profile.t.size(); ++i) {
      CHECK(profile.length[i] == Approx(std::log(1 + profile.t[i])).epsilon(1e-4));
      CHECK(profile.length[i] - profile.length[i - 1] < 0.05);
    }
  }

  TEST_CASE("only the sub-segments above the tolerance are divided") {
    const auto step = [](Point p) { return metric_from_size(p.x < 0.5 ? 0.01 : 1.); };
    const SegmentProfile profile = segment_profile(step, {0, 0}, {1, 0}, 0.25);
    const auto right = std::count_if(profile.t.begin(), profile.t.end(),
                                     [](double t) { return t > 0.5 && t <= 1; });
    CHECK(right == 4);  // 0.5 of length in pieces of 0.125
    CHECK(profile.t.size() > 200);
  }

  TEST_CASE("the metric midpoint halves the length of the segment itself (A13)") {
    // ln(1 + t) = ln(2)/2
    CHECK(metric_midpoint(linear_size, {0, 0}, {1, 0}, 1e-3) ==
          Approx(std::sqrt(2.) - 1).epsilon(1e-6));
    CHECK(metric_midpoint(turning, {0, 0}, {1, 0.3}, 0.01) ==
          Approx(0.47530959718195224).epsilon(1e-5));
    const auto constant = [](Point) { return Metric{5, 2, 3}; };
    for (const double l : {0.8, 1.6, 40.})  // the printed threshold 0.5 would give 0.625 at l = 0.8
      CHECK(metric_midpoint(constant, {0, 0}, {l / 3, -2 * l / 3}) == Approx(0.5).epsilon(1e-14));
  }

  TEST_CASE("cheap formulas on a geometric and on a linear size") {
    // densities 1 and 1/2: geometric variation has the logarithmic mean 0.5 / ln 2
    CHECK(log_mean_length(1, 0.25) == Approx(0.5 / std::log(2.)).epsilon(2e-4));
    CHECK(log_mean_length(4, 4) == Approx(2).epsilon(1e-15));
    CHECK(trapezoid_length(1, 0.25) == 0.75);
    CHECK(simpson_length(1, 4. / 9, 0.25) == Approx(25. / 36).epsilon(1e-15));  // ln 2 = 0.6931
  }
}

TEST_SUITE("property") {
  TEST_CASE("the length does not depend on the direction of the segment") {
    std::mt19937_64 random(41);
    for (int i = 0; i < 300; ++i) {
      const Point a = random_point(random), b = random_point(random);
      CHECK(segment_length(turning, a, b) == Approx(segment_length(turning, b, a)).epsilon(1e-12));
      const double t = metric_midpoint(turning, a, b);
      CHECK(metric_midpoint(turning, b, a) == Approx(1 - t).epsilon(1e-12));
    }
  }
}
