#include "mesher/geometry/curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"

using namespace anisofront;

namespace {

/// A valid curve with random points, weights and knots, some of them repeated.
NurbsCurve random_curve(int degree, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  NurbsCurve curve;
  curve.degree = degree;
  curve.knots.assign(static_cast<std::size_t>(degree) + 1, 0.0);
  double knot = 0;
  for (int span = 0; span < 4; ++span) {
    knot += 0.2 + unit(random);
    const int copies =
        span == 3 ? degree + 1 : std::uniform_int_distribution<int>(1, degree)(random);
    curve.knots.insert(curve.knots.end(), static_cast<std::size_t>(copies), knot);
  }
  const std::size_t count = curve.knots.size() - static_cast<std::size_t>(degree) - 1;
  for (std::size_t i = 0; i < count; ++i) {
    curve.points.push_back({unit(random), unit(random)});
    curve.weights.push_back(0.3 + 2 * unit(random));
  }
  return curve;
}

/// N_{i,p}(t) straight from the recurrence (The NURBS Book, Eqn 2.5): independent of de Boor.
double basis(const std::vector<double>& u, std::size_t i, int p, double t) {
  const auto q = static_cast<std::size_t>(p);
  if (p == 0) return u[i] <= t && t < u[i + 1] ? 1 : 0;
  double value = 0;
  if (u[i + q] > u[i]) value += (t - u[i]) / (u[i + q] - u[i]) * basis(u, i, p - 1, t);
  if (u[i + q + 1] > u[i + 1])
    value += (u[i + q + 1] - t) / (u[i + q + 1] - u[i + 1]) * basis(u, i + 1, p - 1, t);
  return value;
}

Point sum_over_basis(const NurbsCurve& curve, double t) {
  Point sum;
  double weight = 0;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const double n = curve.weights[i] * basis(curve.knots, i, curve.degree, t);
    sum = sum + n * curve.points[i];
    weight += n;
  }
  return (1 / weight) * sum;
}

/// y = x^2 on [-1, 2] as a Bezier curve: the tangents at both ends meet at (1/2, -2).
NurbsCurve parabola() {
  return {2, {-1, -1, -1, 2, 2, 2}, {1, 1, 1}, {{-1, 1}, {0.5, -2}, {2, 4}}};
}

std::string message_of(const NurbsCurve& curve) {
  try {
    validate(curve);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("evaluation agrees with the sum over Cox-de Boor basis functions for any degree") {
    std::mt19937_64 random(1);
    for (const int degree : {1, 2, 3, 4, 5, 7, 9})
      for (int repeat = 0; repeat < 5; ++repeat) {
        const NurbsCurve curve = random_curve(degree, random);
        validate(curve);
        std::uniform_real_distribution<double> inside(0, curve.end_parameter());
        for (int i = 0; i < 20; ++i) {
          const double t = inside(random);
          CHECK(norm(evaluate(curve, t) - sum_over_basis(curve, t)) < 1e-13);
        }
      }
  }

  TEST_CASE("equal control points give that point because the basis is a partition of unity") {
    std::mt19937_64 random(2);
    for (const int degree : {1, 2, 3, 6}) {
      NurbsCurve curve = random_curve(degree, random);
      std::fill(curve.points.begin(), curve.points.end(), Point{3, -7});
      for (int i = 0; i <= 50; ++i)
        CHECK(norm(evaluate(curve, curve.end_parameter() * i / 50.0) - Point{3, -7}) < 1e-14);
    }
  }

  TEST_CASE("an affine map of the control points maps the curve") {
    std::mt19937_64 random(3);
    const auto map = [](Point p) { return Point{3 * p.x - p.y + 2, 0.5 * p.x + 4 * p.y - 1}; };
    NurbsCurve curve = random_curve(3, random), image = curve;
    for (Point& p : image.points) p = map(p);
    for (int i = 0; i <= 50; ++i) {
      const double t = curve.end_parameter() * i / 50.0;
      CHECK(norm(evaluate(image, t) - map(evaluate(curve, t))) < 1e-13);
    }
  }

  TEST_CASE("the ends are exact and parameters outside are clamped") {
    std::mt19937_64 random(4);
    const NurbsCurve curve = random_curve(4, random);
    CHECK(evaluate(curve, curve.begin_parameter()) == curve.points.front());
    CHECK(evaluate(curve, curve.end_parameter()) == curve.points.back());
    CHECK(evaluate(curve, -5) == curve.points.front());
    CHECK(evaluate(curve, 1e9) == curve.points.back());
    CHECK(derivatives(curve, 1e9).first == derivatives(curve, curve.end_parameter()).first);
  }

  TEST_CASE("derivatives agree with finite differences") {
    std::mt19937_64 random(5);
    for (const int degree : {1, 2, 3, 4, 5, 8}) {
      const NurbsCurve curve = random_curve(degree, random);
      const std::vector<double> knots = distinct_knots(curve);
      for (std::size_t k = 1; k < knots.size(); ++k)
        for (const double share : {0.2, 0.5, 0.9}) {
          const double t = knots[k - 1] + share * (knots[k] - knots[k - 1]), h = 1e-4;
          const Point before = evaluate(curve, t - h), at = evaluate(curve, t);
          const Point after = evaluate(curve, t + h);
          const CurveDerivatives d = derivatives(curve, t);
          CAPTURE(degree);
          CHECK(norm(d.point - at) < 1e-14);
          CHECK(norm(d.first - (0.5 / h) * (after - before)) < 3e-5 * (1 + norm(d.first)));
          CHECK(norm(d.second - (1 / (h * h)) * (after - 2 * at + before)) <
                1e-3 * (1 + norm(d.second)));
        }
    }
  }

  TEST_CASE("derivatives are right-sided at inner knots and left-sided at the end") {
    const NurbsCurve corner = make_polyline(std::vector<Point>{{0, 0}, {2, 0}, {2, 3}});
    CHECK(derivatives(corner, 1).first == Vector{0, 3});
    CHECK(derivatives(corner, 0.999).first.x == doctest::Approx(2));
    CHECK(derivatives(corner, 2).first == Vector{0, 3});
    CHECK(unit_tangent(corner, 1) == Vector{0, 1});
    CHECK(unit_tangent(corner, 0) == Vector{1, 0});
  }

  TEST_CASE("the unit tangent is defined where the first derivative vanishes") {
    // Doubled end points: the curve starts towards (1, 1) and ends towards (1, -1).
    const NurbsCurve cusp{
        3, {0, 0, 0, 0, 1, 1, 1, 1}, {1, 1, 1, 1}, {{0, 0}, {0, 0}, {1, 1}, {1, 1}}};
    CHECK(norm(unit_tangent(cusp, 0) - Vector{std::sqrt(0.5), std::sqrt(0.5)}) < 1e-15);
    CHECK(norm(unit_tangent(cusp, 1) - Vector{std::sqrt(0.5), std::sqrt(0.5)}) < 1e-15);
    CHECK(curvature(cusp, 0) == 0);
  }

  TEST_CASE("the curvature of a circle is one over its radius and signed by its direction") {
    for (const double radius : {1e-3, 1.0, 250.0}) {
      const NurbsCurve circle = make_circle({1, 2}, radius);
      for (const double t : {0.0, 0.3, 1.0, 2.7, 4.0})
        CHECK(curvature(circle, t) * radius == doctest::Approx(1).epsilon(1e-12));
      CHECK(curvature(reversed(circle), 1.3) * radius == doctest::Approx(-1).epsilon(1e-12));
    }
  }

  TEST_CASE("the curvature of the parabola y = x^2 is 2 / (1 + 4 x^2)^(3/2)") {
    for (const double x : {-1.0, -0.4, 0.0, 0.5, 1.9}) {
      const CurveDerivatives d = derivatives(parabola(), x);
      CHECK(d.point.x == doctest::Approx(x));
      CHECK(d.point.y == doctest::Approx(x * x));
      CHECK(norm(d.first - Vector{1, 2 * x}) < 1e-14);
      CHECK(norm(d.second - Vector{0, 2}) < 1e-14);
      CHECK(curvature(parabola(), x) == doctest::Approx(2 / std::pow(1 + 4 * x * x, 1.5)));
    }
  }

  TEST_CASE("distinct knots come once each and in order") {
    const NurbsCurve curve{2,
                           {0, 0, 0, 1, 1, 3, 4, 4, 4},
                           {1, 1, 1, 1, 1, 1},
                           {{0, 0}, {1, 0}, {2, 1}, {3, 0}, {4, 1}, {5, 0}}};
    validate(curve);
    CHECK(distinct_knots(curve) == std::vector<double>{0, 1, 3, 4});
  }

  TEST_CASE("a knot of multiplicity equal to the degree puts the curve through a control point") {
    const NurbsCurve curve{
        2, {0, 0, 0, 1, 1, 2, 2, 2}, {1, 0.5, 1, 2, 1}, {{0, 0}, {1, 2}, {3, 1}, {4, 0}, {5, 5}}};
    CHECK(norm(evaluate(curve, 1) - Point{3, 1}) < 1e-15);
  }

  TEST_CASE("a reversed curve runs through the same points") {
    std::mt19937_64 random(6);
    const NurbsCurve curve = random_curve(3, random), back = reversed(curve);
    validate(back);
    const double sum = curve.begin_parameter() + curve.end_parameter();
    for (int i = 0; i <= 20; ++i) {
      const double t = curve.end_parameter() * i / 20.0;
      CHECK(norm(evaluate(back, sum - t) - evaluate(curve, t)) < 1e-13);
    }
    CHECK(back.points.front() == curve.points.back());
  }

  TEST_CASE("a polyline passes its vertices exactly at integer parameters") {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(-1e3, 1e3);
    std::vector<Point> vertices(1000);
    for (Point& p : vertices) p = {unit(random), unit(random)};
    const NurbsCurve curve = make_polyline(vertices);
    for (std::size_t k = 0; k < vertices.size(); ++k)
      CHECK(evaluate(curve, static_cast<double>(k)) == vertices[k]);
  }

  TEST_CASE("validation says which condition of a NURBS curve is broken") {
    const NurbsCurve good = parabola();
    CHECK(message_of(good).empty());
    const auto broken = [&](auto change) {
      NurbsCurve curve = good;
      change(curve);
      return message_of(curve);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(contains(broken([](NurbsCurve& c) { c.degree = 0; }), "degree 0"));
    CHECK(contains(broken([](NurbsCurve& c) { c.degree = 5; }), "3 control points"));
    CHECK(contains(broken([](NurbsCurve& c) { c.weights.pop_back(); }), "2 weights"));
    CHECK(contains(broken([](NurbsCurve& c) { c.knots.pop_back(); }), "5 knots"));
    CHECK(contains(broken([](NurbsCurve& c) { c.knots[3] = -2; }), "knot 3 = -2 after -1"));
    CHECK(contains(broken([](NurbsCurve& c) { c.knots[5] = 3; }), "not clamped"));
    CHECK(contains(broken([](NurbsCurve& c) { c.knots[3] = -1; }), "not clamped"));
    CHECK(contains(broken([&](NurbsCurve& c) { c.knots[1] = nan; }), "knot 1 is not finite"));
    CHECK(contains(broken([](NurbsCurve& c) { c.weights[1] = 0; }), "weight 1 = 0"));
    CHECK(contains(broken([](NurbsCurve& c) { c.weights[2] = -1; }), "weight 2 = -1"));
    CHECK(contains(broken([&](NurbsCurve& c) { c.points[1].y = nan; }), "control point 1"));
    CHECK(contains(broken([](NurbsCurve& c) { c.knots.assign(6, 1); }), "more than degree times"));
    const NurbsCurve torn{1, {0, 0, 1, 1, 2, 2}, {1, 1, 1, 1}, {{0, 0}, {1, 0}, {5, 5}, {6, 5}}};
    CHECK(contains(message_of(torn), "knot 1 occurs more than degree times"));
  }
}
