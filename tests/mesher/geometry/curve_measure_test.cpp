#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <doctest/doctest.h>

#include "mesher/geometry/curve.hpp"

using namespace anisofront;

namespace {

constexpr double kPi = std::numbers::pi;

NurbsCurve parabola() {
  return {2, {-1, -1, -1, 2, 2, 2}, {1, 1, 1}, {{-1, 1}, {0.5, -2}, {2, 4}}};
}

/// Length of y = x^2 from 0 to x: x sqrt(1 + 4 x^2) / 2 + asinh(2 x) / 4.
double parabola_length(double x) {
  return 0.5 * x * std::sqrt(1 + 4 * x * x) + 0.25 * std::asinh(2 * x);
}

double brute_force_distance(const NurbsCurve& curve, Point p, int samples) {
  double best = std::numeric_limits<double>::infinity();
  const double begin = curve.begin_parameter(), end = curve.end_parameter();
  for (int i = 0; i <= samples; ++i)
    best = std::min(best, norm(p - evaluate(curve, begin + (end - begin) * i / samples)));
  return best;
}

void check_nearest(const NurbsCurve& curve, Point p) {
  const NearestPoint nearest = nearest_point(curve, p);
  CHECK(nearest.distance == doctest::Approx(norm(p - nearest.point)).epsilon(1e-12));
  CHECK(norm(evaluate(curve, nearest.parameter) - nearest.point) < 1e-12);
  const double brute = brute_force_distance(curve, p, 4000);
  CHECK(nearest.distance <= brute + 1e-13);
  CHECK(nearest.distance >= brute - 2e-3);  // the samples are that far apart at most
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the length of circles and arcs is radius times angle") {
    const NurbsCurve circle = make_circle({3, -1}, 2.5);
    CHECK(arc_length(circle, 0, 4) == doctest::Approx(5 * kPi).epsilon(1e-12));
    CHECK(arc_length(circle, 1, 2) == doctest::Approx(1.25 * kPi).epsilon(1e-12));
    const NurbsCurve arc = make_arc({0, 0}, 4, 0.2, 3.1);
    CHECK(arc_length(arc, arc.begin_parameter(), arc.end_parameter()) ==
          doctest::Approx(4 * 2.9).epsilon(1e-12));
  }

  TEST_CASE("the length of a parabola agrees with its closed form") {
    CHECK(arc_length(parabola(), -1, 2) ==
          doctest::Approx(parabola_length(2) + parabola_length(1)).epsilon(1e-11));
    CHECK(arc_length(parabola(), 0.25, 1.5) ==
          doctest::Approx(parabola_length(1.5) - parabola_length(0.25)).epsilon(1e-11));
  }

  TEST_CASE("the length does not depend on the order of the parameters and is zero on a point") {
    CHECK(arc_length(parabola(), 1.5, 0.25) == arc_length(parabola(), 0.25, 1.5));
    CHECK(arc_length(parabola(), 0.7, 0.7) == 0);
    CHECK(arc_length(parabola(), -100, 100) == arc_length(parabola(), -1, 2));
  }

  TEST_CASE("the length of polylines is the sum of their segments whatever the weights") {
    NurbsCurve line = make_polyline(std::vector<Point>{{0, 0}, {3, 4}, {3, 10}});
    CHECK(arc_length(line, 0, 2) == 11);
    CHECK(arc_length(line, 0.5, 1.5) == doctest::Approx(5.5));
    line.weights = {1, 5, 0.2};
    CHECK(arc_length(line, 0, 2) == 11);
  }

  TEST_CASE("the length of a thin ellipse agrees with the complete elliptic integral") {
    // 4 a E(e) with a = 1, b = 0.1 (Abramowitz and Stegun, 17.3.3): 4.06397418010089...
    const NurbsCurve ellipse = make_ellipse({0, 0}, 1, 0.1);
    CHECK(arc_length(ellipse, 0, 4) ==
          doctest::Approx(4 * std::comp_ellint_2(std::sqrt(0.99))).epsilon(1e-10));
    CHECK(arc_length(ellipse, 0, 4) == doctest::Approx(4.06397418010090).epsilon(1e-10));
  }

  TEST_CASE("the length of a curve that stops at a cusp is right") {
    // x = t^3, y = t^2 (semicubical parabola) on [-1, 1]: 2 (13^(3/2) - 8) / 27.
    const NurbsCurve cusp{3,
                          {-1, -1, -1, -1, 1, 1, 1, 1},
                          {1, 1, 1, 1},
                          {{-1, 1}, {1, -1.0 / 3}, {-1, -1.0 / 3}, {1, 1}}};
    CHECK(arc_length(cusp, -1, 1) ==
          doctest::Approx(2 * (std::pow(13, 1.5) - 8) / 27).epsilon(1e-10));
  }

  TEST_CASE("the nearest point of a segment is the projection or an end") {
    const NurbsCurve line = make_line({1, 1}, {5, 1});
    CHECK(nearest_point(line, {2, 3}).point == Point{2, 1});
    CHECK(nearest_point(line, {2, 3}).parameter == 0.25);
    CHECK(nearest_point(line, {-2, 5}).point == Point{1, 1});
    CHECK(nearest_point(line, {9, 1}).parameter == 1);
    NurbsCurve weighted = line;
    weighted.weights = {1, 3};
    const NearestPoint nearest = nearest_point(weighted, {2, 3});
    CHECK(nearest.point == Point{2, 1});
    CHECK(norm(evaluate(weighted, nearest.parameter) - Point{2, 1}) < 1e-15);
  }

  TEST_CASE("the nearest point of a circle lies on the ray from the centre") {
    const NurbsCurve circle = make_circle({1, 2}, 3);
    for (int i = 0; i < 100; ++i) {
      const double angle = 0.0628 * i, distance = 0.07 * i;
      const Vector ray{std::cos(angle), std::sin(angle)};
      const NearestPoint nearest = nearest_point(circle, Point{1, 2} + distance * ray);
      CHECK(nearest.distance == doctest::Approx(std::fabs(distance - 3)).epsilon(1e-12));
      if (i > 0) CHECK(norm(nearest.point - (Point{1, 2} + 3 * ray)) < 1e-11);
    }
  }

  TEST_CASE("the nearest point of a long polyline is found at every vertex") {
    std::vector<Point> vertices;
    for (int i = 0; i < 100000; ++i) vertices.push_back({std::cos(1e-4 * i), 1e-5 * i});
    const NurbsCurve curve = make_polyline(vertices);
    for (const int i : {0, 1, 777, 50000, 99999})
      CHECK(nearest_point(curve, vertices[static_cast<std::size_t>(i)]).parameter == i);
  }
}

TEST_SUITE("property") {
  TEST_CASE("nearest points agree with brute force on ellipses splines and free NURBS curves") {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<NurbsCurve> curves{make_ellipse({0, 0}, 1, 0.1, 0.3), make_ellipse({0, 0}, 1, 0.8),
                                   parabola()};
    std::vector<Point> loop;
    for (int i = 0; i < 9; ++i) loop.push_back({unit(random), unit(random)});
    loop.push_back(loop.front());
    curves.push_back(make_spline(loop));
    NurbsCurve quintic{5, {0, 0, 0, 0, 0, 0, 1, 1, 2, 2, 2, 2, 2, 2}, {}, {}};
    for (int i = 0; i < 8; ++i) {
      quintic.points.push_back({unit(random), unit(random)});
      quintic.weights.push_back(1.5 + unit(random));
    }
    curves.push_back(quintic);
    for (const NurbsCurve& curve : curves)
      for (int i = 0; i < 200; ++i) check_nearest(curve, {1.5 * unit(random), 1.5 * unit(random)});
  }

  TEST_CASE("nearest points of an ellipse are right near its centres of curvature") {
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double a = 1, b = 0.6;
    const NurbsCurve ellipse = make_ellipse({0, 0}, a, b);
    for (int i = 0; i < 300; ++i) {
      const double s = kPi * unit(random);
      const double c = (a * a - b * b);
      const Point centre{c / a * std::pow(std::cos(s), 3), -c / b * std::pow(std::sin(s), 3)};
      check_nearest(ellipse, centre + 1e-3 * Point{unit(random), unit(random)});
    }
  }
}
