#include "mesher/front/curve_profile.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/support/domains.hpp"
#include "tests/support/meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;
using doctest::Approx;

namespace {

BackgroundMesh background_of(const MetricFunction& metric, Index n = 8) {
  const Mesh mesh = crossed_rectangle(n, n, {-2, -2}, {2, 2});
  return BackgroundMesh(mesh, sample(mesh, metric));
}

/// Eqn 19 by brute force: the count whose ratio to L, or inverse, is nearest to one.
Index nearest_in_ratio(double length) {
  Index best = 1;
  const auto misfit = [&](Index n) { return std::max(n / length, length / n); };
  for (Index n = 2; n < length + 3; ++n)
    if (misfit(n) < misfit(best)) best = n;
  return best;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the number of segments is the integer nearest in ratio (Eqn 19)") {
    for (int i = 1; i < 20000; ++i) {
      const double length = 0.0013 * i;
      CHECK(segment_count(length) == nearest_in_ratio(length));
    }
    CHECK(segment_count(0) == 1);
    CHECK(segment_count(1e-300) == 1);
    CHECK(segment_count(1.41) == 1);
    CHECK(segment_count(1.42) == 2);
    CHECK(segment_count(23.9) == 24);   // Example 1, M1: 96 edges on four sides
    CHECK(segment_count(34.55) == 35);  // Example 1, intersected: 140
  }

  TEST_CASE("a line in a linear size has its logarithmic length") {
    const BackgroundMesh background =
        background_of([](Point p) { return metric_from_size(0.5 + 0.2 * p.x); });
    Index hint = 0;
    const CurveProfile profile =
        sample_curve(background, make_line({-1, 0}, {1, 0}), 0, 1, 0.1, 1e9, hint);
    CHECK(profile.total() == Approx(std::log(0.7 / 0.3) / 0.2).epsilon(1e-4));
    CHECK(profile.parameter.front() == 0);
    CHECK(profile.parameter.back() == 1);
    CHECK(profile.length.front() == 0);
    for (std::size_t i = 1; i < profile.length.size(); ++i) {
      CHECK(profile.parameter[i] > profile.parameter[i - 1]);
      const double step = profile.length[i] - profile.length[i - 1];
      CHECK(step > 0);
      CHECK(step < 0.1);
    }
  }

  TEST_CASE("a circle has its arc length and a piece of it its share") {
    const BackgroundMesh background = background_of([](Point) { return metric_from_size(0.1); });
    Index hint = 0;
    const NurbsCurve circle = make_circle({0, 0}, 1);
    CHECK(sample_curve(background, circle, 0, 4, 0.1, 1e9, hint).total() ==
          Approx(20 * kPi).epsilon(1e-4));
    CHECK(sample_curve(background, circle, 1, 2, 0.1, 1e9, hint).total() ==
          Approx(5 * kPi).epsilon(1e-4));
  }

  TEST_CASE("a thin layer inside one step is not missed") {
    // One grid line at x = 0 asks for 0.001, its neighbours at a distance of 1/2 for 1.
    const BackgroundMesh background =
        background_of([](Point p) { return metric_from_size(p.x == 0 ? 0.001 : 1); });
    Index hint = 0;
    const double layer = 0.5 * std::log(1000.) / 0.999;  // integral of dx / h, one side, y = 0
    const CurveProfile profile =
        sample_curve(background, make_line({-2, 0}, {2, 0}), 0, 1, 0.1, 1e9, hint);
    CHECK(profile.total() == Approx(2 * layer + 3).epsilon(0.01));
  }

  TEST_CASE("curves that need too many edges are refused with the place") {
    const BackgroundMesh background = background_of([](Point) { return metric_from_size(1e-3); });
    Index hint = 0;
    CHECK_THROWS_AS(sample_curve(background, make_line({-1, 0}, {1, 0}), 0, 1, 0.1, 500, hint),
                    BudgetError);
    CHECK_NOTHROW(sample_curve(background, make_line({-1, 0}, {1, 0}), 0, 1, 0.1, 2001, hint));
  }

  TEST_CASE("equal parts have equal running length (Eqn 20)") {
    const CurveProfile profile{{0, 1, 3, 4}, {0, 1, 2, 6}};
    CHECK(equal_parts(profile, 1) == std::vector<double>{0, 4});
    CHECK(equal_parts(profile, 3) == std::vector<double>{0, 3, 3.5, 4});
    const auto six = equal_parts(profile, 6);
    const double expected[] = {0, 1, 3, 3.25, 3.5, 3.75, 4};
    REQUIRE(six.size() == 7);
    for (int i = 0; i < 7; ++i) CHECK(six[i] == Approx(expected[i]));
  }

  TEST_CASE("old segments are measured with Appendix B (Eqn 18)") {
    Mesh old = crossed_square(2, 2);
    const BackgroundMesh background(
        old, sample(old, [](Point p) { return metric_from_size(0.1 + 0.1 * p.x); }));
    Index hint = 0;
    const std::vector<CurveEdge> edges{old.edges[0], old.edges[4]};  // bottom, left to right
    const CurveProfile profile = measure_old_segments(background, old, edges, hint);
    CHECK(profile.total() == Approx(std::log(3.) / 0.1).epsilon(0.01));
    CHECK(profile.parameter.back() == 1);
    double at_middle = -1;
    for (std::size_t i = 0; i < profile.parameter.size(); ++i)
      if (profile.parameter[i] == 0.5) at_middle = profile.length[i];
    CHECK(at_middle == Approx(std::log(2.) / 0.1).epsilon(0.01));
  }

  TEST_CASE("old segments are measured in a coarser metric as finely as in the metric itself") {
    // The graded side of Example 2 as 16 edges, sizes linear between: half its length is 8.476,
    // below the switch of Eqn 19 at sqrt(72) = 8.485, and the trapezoid rule on quarters of the
    // coarse metric would make 8.490 of it.
    const auto h = [](double x) { return 0.05 + 0.2 * std::pow(x, 1.25); };
    Mesh old = crossed_rectangle(16, 1, {0, 0}, {10, 1});
    std::vector<CurveEdge> edges;
    std::vector<double> ends{0};
    for (double x = 0, length = 0; ends.size() < 16;) {
      constexpr double kStep = 1e-4, kTotal = 16.989;  // of the side
      x += kStep;
      length += kStep / h(x - 0.5 * kStep);
      if (length >= kTotal / 16 * static_cast<double>(ends.size())) ends.push_back(x);
    }
    ends.push_back(10);
    double exact = 0;  // half of the integral of dx / h with h linear between the ends
    for (Index i = 0; i < 16; ++i) {
      old.points[i + 1].x = old.points[i + 18].x = ends[i + 1];
      old.points[34 + i].x = 0.5 * (ends[i] + ends[i + 1]);
      edges.push_back({{i, i + 1}, 1, 0, {ends[i] / 10, ends[i + 1] / 10}});
      const double h0 = h(ends[i]), h1 = h(ends[i + 1]);
      exact += 0.5 * (ends[i + 1] - ends[i]) * std::log(h1 / h0) / (h1 - h0);
    }
    REQUIRE(exact == Approx(8.4765).epsilon(1e-4));
    BackgroundMesh background(old, sample(old, [&](Point p) { return metric_from_size(h(p.x)); }));
    background.set_size_factor(2);
    Index hint = 0;
    const double length = measure_old_segments(background, old, edges, hint).total();
    CHECK(length == Approx(exact).epsilon(8e-4));
    CHECK(segment_count(length) == 8);
    background.set_size_factor(1);
    CHECK(measure_old_segments(background, old, edges, hint).total() ==
          Approx(2 * exact).epsilon(8e-4));
  }

  TEST_CASE("a straight chord is measured by the size along it") {
    const BackgroundMesh background = background_of([](Point p) {
      return metric_from_sizes(0.2, 0.5 + 0.1 * p.x, {0, 1});
    });
    Index hint = 0;
    CHECK(chord_length(background, {0, 0}, {0, 1}, hint) == Approx(5).epsilon(1e-6));
    CHECK(chord_length(background, {0, 0}, {1, 0}, hint) ==
          Approx(std::log(0.6 / 0.5) / 0.1).epsilon(1e-3));
  }

  TEST_CASE("chords across a thin direction are counted by their own length and come out equal") {
    // Radial size 0.02, tangential 0.4: chords of n edges have radial height about pi^2 / (2 n^2).
    const BackgroundMesh background = background_of(
        [](Point p) {
          return metric_from_sizes(0.02, 0.4, norm(p) > 0 ? p : Point{1, 0});
        },
        24);
    Index hint = 0;
    const NurbsCurve arc = make_arc({0, 0}, 1, 0, kPi);
    const CurveProfile profile = sample_curve(background, arc, 0, 2, 0.1, 1e9, hint);
    const auto ends = equal_chords(background, arc, profile, 1, hint);
    CHECK(static_cast<Index>(ends.size()) - 1 > segment_count(profile.total()));
    double low = 1e300, high = 0;
    for (std::size_t k = 1; k < ends.size(); ++k) {
      const double chord =
          chord_length(background, evaluate(arc, ends[k - 1]), evaluate(arc, ends[k]), hint);
      low = std::min(low, chord);
      high = std::max(high, chord);
    }
    CHECK(high < 1.1 * low);
    CHECK(high < 1.42);
    CHECK(low > 0.5);
  }

  TEST_CASE("where the size is uniform chords are equal parts of the curve") {
    const BackgroundMesh background = background_of([](Point) { return metric_from_size(0.25); });
    Index hint = 0;
    const NurbsCurve circle = make_circle({0, 0}, 1);
    const CurveProfile profile = sample_curve(background, circle, 0, 4, 0.1, 1e9, hint);
    const auto ends = equal_chords(background, circle, profile, 3, hint);
    REQUIRE(ends.size() == 26);  // 8 pi = 25.13
    for (std::size_t k = 1; k < ends.size(); ++k)
      CHECK(norm(evaluate(circle, ends[k]) - evaluate(circle, ends[k - 1])) ==
            Approx(2 * std::sin(kPi / 25)).epsilon(0.01));
  }
}
