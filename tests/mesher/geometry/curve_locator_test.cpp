#include "mesher/geometry/curve_locator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"

using namespace anisofront;

namespace {

/// An opening of Example 4 (paper/examples.json): half circles of radius `radius` at both ends of
/// the segment from -half to +half round `centre`. A circle when half is zero.
struct Stadium {
  Point centre;
  Vector half;
  double radius;

  double distance(Point p) const {
    const double length2 = squared_norm(half);
    const double s = length2 > 0 ? std::clamp(dot(p - centre, half) / length2, -1.0, 1.0) : 0;
    return std::fabs(norm(p - (centre + s * half)) - radius);
  }
};

/// All its openings that are stadiums: two of the L-shaped bracket, two of the rectangle.
const std::vector<Stadium> kStadiums{{{135, 15}, {23, 0}, 7},
                                     {{15, 95}, {0, 19}, 6},
                                     {{120, 5.9}, {27.5, 0}, 3.5},
                                     {{5.9, 95}, {0, 12.5}, 3.5}};

/// Clockwise rational quadratics with the rounded weights and the knots of the file.
NurbsCurve stadium_curve(const Stadium& s) {
  const double r = s.radius, w = 0.707106781186548;
  const auto [cx, cy] = s.centre;
  NurbsCurve curve;
  curve.degree = 2;
  curve.knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 6};
  if (s.half.x > 0) {
    const double l = cx - s.half.x, m = cx + s.half.x;
    curve.points = {{l, cy - r}, {l - r, cy - r}, {l - r, cy}, {l - r, cy + r},
                    {l, cy + r}, {cx, cy + r},    {m, cy + r}, {m + r, cy + r},
                    {m + r, cy}, {m + r, cy - r}, {m, cy - r}, {cx, cy - r},
                    {l, cy - r}};
    curve.weights = {1, w, 1, w, 1, 1, 1, w, 1, w, 1, 1, 1};
  } else {
    const double l = cy - s.half.y, m = cy + s.half.y;
    curve.points = {{cx, l - r},     {cx - r, l - r}, {cx - r, l},     {cx - r, cy}, {cx - r, m},
                    {cx - r, m + r}, {cx, m + r},     {cx + r, m + r}, {cx + r, m},  {cx + r, cy},
                    {cx + r, l},     {cx + r, l - r}, {cx, l - r}};
    curve.weights = {1, w, 1, 1, 1, w, 1, w, 1, 1, 1, w, 1};
  }
  return curve;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the stadium openings of Example 4 are exact to 1e-12 of their radius") {
    for (const Stadium& s : kStadiums) {
      const NurbsCurve curve = stadium_curve(s);
      validate(curve);
      CHECK(is_closed(curve));
      double error = 0;
      for (int i = 0; i <= 3000; ++i)
        error = std::max(error, s.distance(evaluate(curve, 6 * i / 3000.0)));
      CHECK(error < 1e-12 * s.radius);
      CHECK(arc_length(curve, 0, 6) ==
            doctest::Approx(4 * norm(s.half) + 2 * std::numbers::pi * s.radius).epsilon(1e-11));
    }
  }

  TEST_CASE("distances to a circle agree with the formula everywhere and with the tangent") {
    const Point centre{15, 15};
    const CurveLocator locator({reversed(make_circle(centre, 6))});
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> place(0, 30);
    for (int i = 0; i < 2000; ++i) {
      const Point p{place(random), place(random)};
      const CurveProjection nearest = locator.nearest(p);
      CHECK(nearest.distance == doctest::Approx(std::fabs(norm(p - centre) - 6)).epsilon(1e-11));
      CHECK(nearest.curvature == doctest::Approx(-1.0 / 6).epsilon(1e-11));
      const Vector ray = (1 / norm(p - centre)) * (p - centre);
      CHECK(norm(nearest.tangent - Vector{ray.y, -ray.x}) < 1e-9);
      CHECK(norm(nearest.point - (centre + 6 * ray)) < 1e-9);
    }
  }

  TEST_CASE("distances to stadiums are right also at the joins of arcs and sides") {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> shift(-1, 1);
    for (const Stadium& s : kStadiums) {
      const NurbsCurve curve = stadium_curve(s);
      const CurveLocator locator({curve});
      const double reach = 3 * (norm(s.half) + s.radius);
      for (int i = 0; i < 1000; ++i) {
        const Point p = s.centre + reach * Vector{shift(random), shift(random)};
        CHECK(std::fabs(locator.nearest(p).distance - s.distance(p)) < 1e-10);
      }
      for (double t = 0; t <= 6; t += 1)
        for (const double offset : {0.0, 1e-9, 0.5, -0.5, 4.0}) {
          const Vector tangent = unit_tangent(curve, t);
          const Point p = evaluate(curve, t) + offset * Vector{-tangent.y, tangent.x};
          const CurveProjection nearest = locator.nearest(p);
          CHECK(std::fabs(nearest.distance - std::fabs(offset)) < 1e-12);
          CHECK(norm(nearest.tangent - tangent) < 1e-6);
          const double turn = -nearest.curvature * s.radius;  // 1 on the arcs, 0 on the sides
          CHECK(std::min(std::fabs(turn), std::fabs(turn - 1)) < 1e-9);
        }
    }
  }

  TEST_CASE("the nearest of several curves is found with its index") {
    std::vector<NurbsCurve> curves;
    for (const Stadium& s : kStadiums) curves.push_back(stadium_curve(s));
    curves.push_back(make_polyline(std::vector<Point>{{0, 160}, {30, 160}, {30, 30}}));
    const CurveLocator locator(curves);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> x(-10, 250), y(-10, 170);
    for (int i = 0; i < 1000; ++i) {
      const Point p{x(random), y(random)};
      const CurveProjection nearest = locator.nearest(p);
      double least = std::numeric_limits<double>::infinity();
      for (const NurbsCurve& curve : curves)
        least = std::min(least, nearest_point(curve, p).distance);
      CHECK(nearest.distance == doctest::Approx(least).epsilon(1e-13));
      const NurbsCurve& curve = curves[static_cast<std::size_t>(nearest.curve)];
      CHECK(norm(evaluate(curve, nearest.parameter) - nearest.point) < 1e-11);
    }
  }

  TEST_CASE("equal distances go to the first curve") {
    const CurveLocator locator({make_line({0, 1}, {5, 1}), make_line({0, -1}, {5, -1})});
    CHECK(locator.nearest({2, 0}).curve == 0);
    CHECK(locator.nearest({2, -0.001}).curve == 1);
  }

  TEST_CASE("the locator of a polyline of 1e5 vertices agrees with its segments") {
    std::vector<Point> vertices;
    for (int i = 0; i <= 100000; ++i) vertices.push_back({1e-4 * i, std::sin(3e-4 * i)});
    const CurveLocator locator({make_polyline(vertices)});
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> x(-1, 11), y(-2, 2);
    for (int i = 0; i < 20; ++i) {
      const Point p{x(random), y(random)};
      double least = std::numeric_limits<double>::infinity();
      for (const Point v : vertices) least = std::min(least, norm(p - v));
      const double distance = locator.nearest(p).distance;
      CHECK(distance <= least);
      CHECK(distance >= least - 2e-4);
    }
  }

  TEST_CASE("a locator without curves or with a broken one is refused") {
    CHECK_THROWS_WITH_AS(CurveLocator({}), doctest::Contains("found no curve"), InputError);
    NurbsCurve broken = make_line({0, 0}, {1, 0});
    broken.weights[0] = -1;
    CHECK_THROWS_AS(CurveLocator({broken}), InputError);
  }
}
