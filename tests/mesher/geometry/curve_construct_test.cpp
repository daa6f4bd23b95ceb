#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>

#include "mesher/geometry/curve.hpp"
#include "mesher/geometry/error.hpp"

using namespace anisofront;

namespace {

constexpr double kPi = std::numbers::pi;

template <class Function>
void for_each_sample(const NurbsCurve& curve, const Function& visit) {
  for (int i = 0; i <= 400; ++i)
    visit(evaluate(curve, std::lerp(curve.begin_parameter(), curve.end_parameter(), i / 400.0)));
}

double radius_error(const NurbsCurve& curve, Point centre, double radius) {
  double error = 0;
  for_each_sample(curve, [&](Point p) {
    error = std::max(error, std::fabs(norm(p - centre) - radius) / radius);
  });
  return error;
}

std::vector<Point> circle_points(int count, double sweep) {
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i)
    points.push_back({std::cos(sweep * i / count), std::sin(sweep * i / count)});
  return points;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("circles are exact and closed") {
    for (const double radius : {1e-6, 1.0, 6.0, 1e5}) {
      const NurbsCurve circle = make_circle({0, 0}, radius);
      validate(circle);
      CHECK(is_closed(circle));
      CHECK(radius_error(circle, {0, 0}, radius) < 1e-14);
      CHECK(evaluate(circle, 0) == Point{radius, 0});
      CHECK(norm(evaluate(circle, 1) - Point{0, radius}) < 1e-15 * radius);
    }
    CHECK(radius_error(make_circle({3, -4}, 2), {3, -4}, 2) < 1e-14);
  }

  TEST_CASE("ellipses are exact and start at the end of the first semi-axis") {
    const Point centre{2, 1};
    const double rotation = 0.7, a = 3, b = 0.5;
    const NurbsCurve ellipse = make_ellipse(centre, a, b, rotation);
    const Vector axis{std::cos(rotation), std::sin(rotation)}, normal{-axis.y, axis.x};
    CHECK(norm(evaluate(ellipse, 0) - (centre + a * axis)) < 1e-15);
    CHECK(norm(evaluate(ellipse, 1) - (centre + b * normal)) < 1e-15);
    for_each_sample(ellipse, [&](Point p) {
      const double x = dot(p - centre, axis) / a, y = dot(p - centre, normal) / b;
      CHECK(std::fabs(x * x + y * y - 1) < 1e-14);
    });
  }

  TEST_CASE("arcs are exact in both directions and split into pieces of 90 degrees at most") {
    struct Case {
      double start, end;
      std::size_t pieces;
    };
    for (const Case c : {Case{0, 0.5 * kPi, 1}, Case{0.3, 0.3 + kPi, 2}, Case{1, -2, 2},
                         Case{-1, 4, 4}, Case{0, 1e-3, 1}, Case{2, 2 + 2 * kPi, 4}}) {
      const NurbsCurve arc = make_arc({1, 1}, 2, c.start, c.end);
      validate(arc);
      CHECK(radius_error(arc, {1, 1}, 2) < 1e-14);
      CHECK(distinct_knots(arc).size() == c.pieces + 1);
      CHECK(norm(arc.points.front() - Point{1 + 2 * std::cos(c.start), 1 + 2 * std::sin(c.start)}) <
            1e-15);
      CHECK(norm(arc.points.back() - Point{1 + 2 * std::cos(c.end), 1 + 2 * std::sin(c.end)}) <
            2e-15);
      const double turn = curvature(arc, 0.4);
      CHECK(turn == doctest::Approx(c.end > c.start ? 0.5 : -0.5));
    }
    CHECK(is_closed(make_arc({1, 1}, 2, 2, 2 + 2 * kPi)));
    CHECK_FALSE(is_closed(make_arc({1, 1}, 2, 2, 6)));
  }

  TEST_CASE("a spline through points of a circle converges to it with the sixth order") {
    double before = 0;
    for (const int count : {8, 16, 32}) {
      const NurbsCurve open = make_spline(circle_points(count, 4.0));
      const double error = radius_error(open, {0, 0}, 1);
      const double h = 4.0 / count;
      CHECK(error < 0.01 * std::pow(h, 4));
      if (before > 0) CHECK(std::log2(before / error) > 5.5);
      before = error;
    }
  }

  TEST_CASE("a closed spline is smooth at its seam unless that is a corner") {
    std::vector<Point> points = circle_points(12, 2 * kPi);
    points.back() = points.front();
    const NurbsCurve smooth = make_spline(points);
    CHECK(is_closed(smooth));
    CHECK(radius_error(smooth, {0, 0}, 1) < 1e-4);
    CHECK(norm(unit_tangent(smooth, 0) - unit_tangent(smooth, 12)) < 1e-14);
    const std::vector<Point> drop{{0, 0}, {2, -1}, {3, 0}, {2, 1}, {0, 0}};
    const NurbsCurve pointed = make_spline(drop, SplineSeam::corner);
    CHECK(norm(unit_tangent(pointed, 0) - unit_tangent(pointed, 4)) > 0.5);
    CHECK(norm(unit_tangent(make_spline(drop), 0) - unit_tangent(make_spline(drop), 4)) < 1e-14);
  }

  TEST_CASE("a spline has its vertices at integer parameters and one tangent direction at each") {
    const std::vector<Point> vertices{{0, 0}, {1, 0.2}, {1.1, 0.9}, {3, 1}, {4, -2}};
    const NurbsCurve spline = make_spline(vertices);
    validate(spline);
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const auto t = static_cast<double>(k);
      CHECK(norm(evaluate(spline, t) - vertices[k]) < 1e-15);
      if (k > 0 && k + 1 < vertices.size())
        CHECK(cross(unit_tangent(spline, t - 1e-9), unit_tangent(spline, t)) ==
              doctest::Approx(0).epsilon(1e-7));
    }
  }

  TEST_CASE("a spline through points of a line is the line and does not overshoot") {
    const NurbsCurve spline = make_spline(std::vector<Point>{{0, 0}, {1, 1}, {1.5, 1.5}, {9, 9}});
    for_each_sample(spline, [](Point p) { CHECK(std::fabs(p.x - p.y) < 1e-15); });
    double last = -1;
    for_each_sample(spline, [&](Point p) {
      CHECK(p.x > last);
      last = p.x;
    });
    CHECK(norm(evaluate(make_spline(std::vector<Point>{{0, 0}, {2, 1}}), 0.5) - Point{1, 0.5}) <
          1e-15);
  }

  TEST_CASE("constructors refuse what has no shape") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH_AS(make_line({1, 2}, {1, 2}),
                         doctest::Contains("vertices 1 and 2 both lie at (1, 2)"), InputError);
    CHECK_THROWS_WITH_AS(make_polyline(std::vector<Point>{{0, 0}}),
                         doctest::Contains("found 1 vertices"), InputError);
    CHECK_THROWS_WITH_AS(make_spline(std::vector<Point>{{0, 0}, {1, 0}, {1, 0}}),
                         doctest::Contains("spline: vertices 2 and 3"), InputError);
    CHECK_THROWS_WITH_AS(make_circle({0, 0}, -1), doctest::Contains("radius -1"), InputError);
    CHECK_THROWS_WITH_AS(make_circle({0, nan}, 1), doctest::Contains("(0, nan)"), InputError);
    CHECK_THROWS_WITH_AS(make_ellipse({0, 0}, 1, 0), doctest::Contains("radius 0"), InputError);
    CHECK_THROWS_WITH_AS(make_arc({0, 0}, 1, 2, 2), doctest::Contains("angles 2 and 2"),
                         InputError);
    CHECK_THROWS_WITH_AS(make_arc({0, 0}, 1, 0, 7), doctest::Contains("full turn"), InputError);
  }
}
