#include "mesher/quads/mixed_midpoint.hpp"

#include <doctest/doctest.h>

#include "tests/support/mixed_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

WorkVertex at(const BackgroundMesh& background, Point p) {
  WorkVertex v{p, {}, 0};
  v.r = background.factor_at(p, v.hint);
  return v;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the midpoint of a graded edge halves its metric length") {
    // Size a + b x: the length up to x is ln(1 + b x / a) / b, half of that over [0, 1] lies where
    // the size is the geometric mean of those at the ends.
    struct Case {
      double a, b, paper_error, coarse_error;
    };
    for (const Case& c :
         {Case{0.5, 0.5, 1e-3, 1e-2}, {0.25, 1, 2e-3, 3e-2}, {1, -0.9, 2e-3, 5e-2}}) {
      const auto metric =
          background([&](Point p) { return metric_from_size(c.a + c.b * p.x); }, {0, 0}, {1, 1}, 1);
      const double expected = (std::sqrt(c.a * (c.a + c.b)) - c.a) / c.b;
      const WorkVertex from = at(*metric, {0, 0.3}), to = at(*metric, {1, 0.3});
      const WorkVertex paper = MidpointFinder(*metric, 0.25).of_edge(from, to);
      const WorkVertex coarse = MidpointFinder(*metric, 1.25).of_edge(to, from);
      CHECK(std::fabs(paper.p.x - expected) < c.paper_error);
      CHECK(std::fabs(coarse.p.x - expected) < c.coarse_error);
      CHECK(paper.p.y == 0.3);
      CHECK(1 / paper.r.a == doctest::Approx(c.a + c.b * paper.p.x).epsilon(1e-12));
    }
  }

  TEST_CASE("the midpoint of an edge in a constant metric is the arithmetic one") {
    const auto metric = background(
        [](Point) {
          return metric_from_sizes(0.01, 3, {1, 2});
        },
        {0, 0}, {1, 1});
    const WorkVertex m = MidpointFinder(*metric, 0.25)
                             .of_edge(at(*metric, {0.125, 0.25}), at(*metric, {0.625, 0.75}));
    CHECK(m.p.x == doctest::Approx(0.375).epsilon(1e-14));
    CHECK(m.p.y == doctest::Approx(0.5).epsilon(1e-14));
  }

  TEST_CASE("the midpoint of an arc lies on the circle half way round it") {
    const auto metric =
        background([](Point) { return metric_from_size(0.5); }, {-1.1, -1.1}, {1.1, 1.1});
    const NurbsCurve circle = make_circle({0, 0}, 1);
    MidpointFinder finder(*metric, 0.25);
    const auto halve = [&](double t0, double t1) {
      const Segment s{0, 1, 0, t0, t1, 0, kNoIndex};
      return finder.of_segment(circle, s, at(*metric, evaluate(circle, t0)),
                               at(*metric, evaluate(circle, t1)));
    };
    const MidpointFinder::OnCurve quarter = halve(0, 1);
    CHECK(quarter.parameter == doctest::Approx(0.5).epsilon(1e-14));
    CHECK(norm(quarter.vertex.p - Point{std::sqrt(0.5), std::sqrt(0.5)}) < 1e-14);
    for (const auto& [t0, t1] : {std::pair{0.1, 0.7}, {0.5, 2.2}, {3.5, 4.}}) {
      const MidpointFinder::OnCurve m = halve(t0, t1);
      const Point a = evaluate(circle, t0), b = evaluate(circle, t1);
      CHECK(std::fabs(norm(m.vertex.p) - 1) < 1e-15 * 4);
      CHECK(norm(evaluate(circle, m.parameter) - m.vertex.p) == 0);
      CHECK(norm(m.vertex.p - a) == doctest::Approx(norm(m.vertex.p - b)).epsilon(0.01));
    }
  }

  TEST_CASE("the midpoint of a line along an axis has its coordinate to the last bit") {
    const auto metric =
        background([](Point p) { return metric_from_size(0.3 + 0.1 * p.x); }, {0, 0}, {1, 1});
    const NurbsCurve line = make_line({0, 0.1}, {1, 0.1});
    MidpointFinder finder(*metric, 0.25);
    for (int k = 0; k < 50; ++k) {
      const double t0 = 0.01 * k, t1 = t0 + 0.37;
      const Segment s{0, 1, 0, t0, t1, 0, kNoIndex};
      const auto m = finder.of_segment(line, s, at(*metric, {t0, 0.1}), at(*metric, {t1, 0.1}));
      CHECK(m.vertex.p.y == 0.1);
      CHECK(m.vertex.p.x == doctest::Approx(m.parameter).epsilon(1e-14));
      CHECK(m.parameter > t0);
      CHECK(m.parameter < t1);
    }
  }
}
