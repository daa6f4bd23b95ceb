#include "adapt/patch_fit.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

double quadratic(Point p) {
  return 3 - 2 * p.x + 5 * p.y + 0.5 * p.x * p.x - 4 * p.x * p.y + p.y * p.y;
}

std::vector<Point> cloud(int count, double stretch, std::uint64_t seed) {
  Noise noise(seed);
  std::vector<Point> points;
  // Stretched along a direction that is no axis.
  for (int i = 0; i < count; ++i) {
    const double along = noise(), across = noise() / stretch;
    points.push_back({0.7 + 0.8 * along - 0.6 * across, -0.4 + 0.6 * along + 0.8 * across});
  }
  return points;
}

PatchFrame frame_of(Point origin, const std::vector<Point>& points) {
  PatchMoments moments;
  for (const Point& p : points) moments.add(p - origin);
  return patch_frame(origin, moments);
}

PatchFit fit_of(const std::vector<Point>& points, int degree) {
  PatchFit fit(frame_of(points[0] - Vector{0.01, 0.02}, points), degree, 1);
  for (const Point& p : points) {
    const double value = quadratic(p);
    fit.add(p, 1, &value);
  }
  return fit;
}

double value_at(const PatchPolynomial& polynomial, Point x) {
  const Terms t = terms_at(polynomial.frame.coordinates(x));
  double sum = 0;
  for (int i = 0; i < kMaxTerms; ++i) sum += t[i] * polynomial.coefficients[i][0];
  return sum;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("patch coordinates have mean zero and unit covariance") {
    const auto points = cloud(9, 1000, 5);
    const PatchFrame frame = frame_of({0.7, -0.4}, points);
    double xx = 0, xy = 0, yy = 0;
    Vector mean;
    for (const Point& p : points) {
      const Vector y = frame.coordinates(p);
      mean = mean + 1. / 9 * y;
      xx += y.x * y.x / 9;
      xy += y.x * y.y / 9;
      yy += y.y * y.y / 9;
    }
    CHECK(norm(mean) < 1e-9);
    CHECK(xx == doctest::Approx(1));
    CHECK(xy == doctest::Approx(0).scale(1).epsilon(1e-8));
    CHECK(yy == doctest::Approx(1));
  }

  TEST_CASE("a quadratic is fitted exactly on clouds stretched up to ten thousand") {
    for (const double stretch : {1., 100., 1e4}) {
      const auto points = cloud(12, stretch, 8);
      const PatchFit fit = fit_of(points, 2);
      CHECK(fit.is_determined());
      const PatchPolynomial p = fit.solve();
      for (const Point& x : points)
        CHECK(value_at(p, x) == doctest::Approx(quadratic(x)).epsilon(1e-9));
      const Point between = lerp(points[3], points[7], 0.4);
      CHECK(value_at(p, between) == doctest::Approx(quadratic(between)).epsilon(1e-9));
    }
  }

  TEST_CASE("a linear fit is the least-squares plane") {
    // Values 0, 0, 0, 1 at the corners of a square: the plane -1/4 + x/2 + y/2.
    const std::vector<Point> corners{{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    PatchFit fit(frame_of({0.2, 0.3}, corners), 1, 2);
    for (const Point& p : corners) {
      const double values[] = {p.x * p.y, 7};
      fit.add(p, 0.5, values);
    }
    const PatchPolynomial p = fit.solve();
    CHECK(value_at(p, {0, 0}) == doctest::Approx(-0.25));
    CHECK(value_at(p, {1, 0}) == doctest::Approx(0.25));
    CHECK(value_at(p, {3, 1}) == doctest::Approx(1.75));
    CHECK(p.coefficients[0][1] == doctest::Approx(7));
  }

  TEST_CASE("samples that do not determine all terms give a polynomial of fewer") {
    // On a line: quadratics along it are fitted, those across are not known.
    std::vector<Point> line;
    for (int i = 0; i < 7; ++i) line.push_back({0.1 * i, 2.});
    PatchFit fit({{0.3, 1.9}, 0.2, 0, 0.1}, 2, 1);
    for (const Point& p : line) {
      const double value = quadratic(p);
      fit.add(p, 1, &value);
    }
    CHECK_FALSE(fit.is_determined());
    const PatchPolynomial p = fit.solve();
    for (const Point& x : line) CHECK(value_at(p, x) == doctest::Approx(quadratic(x)));

    PatchFit single({{0, 0}, 1, 0, 1}, 2, 1);
    const double value = 4;
    single.add({0.3, 0.2}, 1, &value);
    CHECK_FALSE(single.is_determined());
    CHECK(value_at(single.solve(), {0.3, 0.2}) == doctest::Approx(4));
    CHECK(value_at(PatchFit({{0, 0}, 1, 0, 1}, 1, 1).solve(), {5, 5}) == 0);
  }

  TEST_CASE("a polynomial in another frame is the same polynomial") {
    const PatchPolynomial p = fit_of(cloud(12, 50, 3), 2).solve();
    const PatchPolynomial q = in_frame(PatchFrame{{2, 1}, 0.5, 0.3, 0.01}, p);
    for (const Point x : {Point{0.7, -0.4}, {0, 0}, {2, 1}})
      CHECK(value_at(q, x) == doctest::Approx(value_at(p, x)).epsilon(1e-9));
  }

  TEST_CASE("stored polynomials come back with the terms of their degree") {
    PatchPolynomials polynomials(3, 1, 1);
    const PatchPolynomial p = fit_of(cloud(12, 5, 3), 1).solve();
    polynomials.set(1, p);
    CHECK(polynomials[1].coefficients == p.coefficients);
    double value = 1;
    polynomials.add_value(1, {0.4, 0.1}, 3, &value);
    CHECK(value == doctest::Approx(1 + 3 * value_at(p, {0.4, 0.1})));
  }
}
