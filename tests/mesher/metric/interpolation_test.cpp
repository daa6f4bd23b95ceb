// Literals were computed with 40 digits (mpmath): generalised eigenvectors by Cholesky and a
// symmetric eigensolver, matrix functions through the spectrum.
#include "mesher/metric/interpolation.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "tests/mesher/metric/random_metric.hpp"

using namespace anisofront;
using doctest::Approx;

namespace {

const Metric kA{5, 2, 3}, kB{1, -0.5, 4}, kC{0.5, 0.2, 0.3}, kD{6, -3, 2};
constexpr Interpolation kMethods[] = {Interpolation::linear_size,
                                      Interpolation::simultaneous_reduction,
                                      Interpolation::log_euclidean};

void check_close(const Metric& found, const Metric& expected, double tolerance = 1e-14) {
  const double scale = expected.m11 + expected.m22;
  CHECK(std::fabs(found.m11 - expected.m11) <= tolerance * scale);
  CHECK(std::fabs(found.m12 - expected.m12) <= tolerance * scale);
  CHECK(std::fabs(found.m22 - expected.m22) <= tolerance * scale);
}

double form(const Metric& m, Vector a, Vector b) { return inner_product(m, a, b); }

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("simultaneous reduction solves the generalised eigenproblem of Eqn 4") {
    const SimultaneousReduction r = simultaneous_reduction(kA, kB);
    CHECK(std::min(r.lambda1, r.lambda2) == Approx(0.47365192139637112).epsilon(1e-14));
    CHECK(std::max(r.lambda1, r.lambda2) == Approx(6.1930147452702955).epsilon(1e-14));
    CHECK(r.mu1 == 1);
    CHECK(r.mu2 == 1);
    for (const auto& [s, lambda] : {std::pair{r.s1, r.lambda1}, std::pair{r.s2, r.lambda2}}) {
      const Vector residual = kA * s - lambda * (kB * s);  // M1 S = M2 S Lambda
      CHECK(norm(residual) < 1e-14);
      CHECK(form(kB, s, s) == Approx(1).epsilon(1e-14));
    }
    CHECK(std::fabs(form(kB, r.s1, r.s2)) < 1e-15);
  }

  TEST_CASE("reduction is regular for equal and for isotropic metrics") {
    for (const Metric& m : {kA, kB, Metric{2, 0, 2}}) {
      const SimultaneousReduction r = simultaneous_reduction(m, m);
      CHECK(r.lambda1 == Approx(1).epsilon(1e-15));
      CHECK(r.lambda2 == Approx(1).epsilon(1e-15));
      check_close(metric_from_reduction(r.s1, r.s2, r.lambda1, r.lambda2), m);
    }
    const SimultaneousReduction r = simultaneous_reduction({2, 0, 2}, {8, 0, 8});
    CHECK(r.lambda1 == 0.25);
    CHECK(r.lambda2 == 0.25);
  }

  TEST_CASE("interpolation along a segment at t = 0.3") {
    const Metric expected[] = {{2.4446811338486527, 0.68641919659768287, 2.8164195417011244},
                               {2.4624287816361473, 0.6437945395912632, 2.7663480561093166},
                               {2.930837826653752, 0.93228872622852407, 3.014201027436072}};
    for (int i = 0; i < 3; ++i) check_close(interpolate(kMethods[i], kA, kB, 0.3), expected[i]);
  }

  TEST_CASE("sizes of metrics with common axes vary linearly or geometrically") {
    const Metric m1 = metric_from_sizes(0.1, 1, {3, 4}), m2 = metric_from_sizes(0.4, 9, {3, 4});
    const Metric linear = metric_from_sizes(0.25, 5, {3, 4});
    const Metric geometric = metric_from_sizes(0.2, 3, {3, 4});
    check_close(interpolate(Interpolation::linear_size, m1, m2, 0.5), linear);
    check_close(interpolate(Interpolation::simultaneous_reduction, m1, m2, 0.5), linear);
    check_close(interpolate(Interpolation::log_euclidean, m1, m2, 0.5), geometric);
  }

  TEST_CASE("interpolation in a triangle at barycentric coordinates 0.2 0.3 0.5") {
    const Metric expected[] = {{0.78928497102873485, 0.27980434023641629, 0.65227545037065118},
                               {0.79210071398754697, 0.27224306085622337, 0.64373883296131085},
                               {0.92681229848036051, 0.29481558117792959, 0.95317405723176668}};
    for (int i = 0; i < 3; ++i)
      check_close(interpolate(kMethods[i], {kA, kB, kC}, {0.2, 0.3, 0.5}), expected[i]);
  }

  TEST_CASE("the value in a triangle does not depend on the order of its vertices") {
    for (const Interpolation method : kMethods) {
      const Metric m = interpolate(method, {kA, kB, kC}, {0.2, 0.3, 0.5});
      check_close(interpolate(method, {kC, kA, kB}, {0.5, 0.2, 0.3}), m);
      check_close(interpolate(method, {kB, kA, kC}, {0.3, 0.2, 0.5}), m);
    }
  }

  TEST_CASE("interpolation in a quadrilateral at (0.25 0.6)") {
    const Metric expected[] = {{1.7355344771710921, -0.29138987907058373, 0.79503285141525452},
                               {1.6630296846765514, -0.31127901786447131, 0.83444446554831916},
                               {2.6452406361743119, -0.5631636391427215, 1.1628595658712}};
    for (int i = 0; i < 3; ++i)
      check_close(interpolate(kMethods[i], {kA, kB, kC, kD}, 0.25, 0.6), expected[i]);
  }

  TEST_CASE("vertices return their own metric and edges the value along the edge") {
    const Metric corners[4] = {kA, kB, kC, kD};
    const double xi[4] = {0, 1, 1, 0}, eta[4] = {0, 0, 1, 1};
    for (const Interpolation method : kMethods) {
      for (std::size_t k = 0; k < 3; ++k) {
        std::array<double, 3> w{0, 0, 0};
        w[k] = 1;
        check_close(interpolate(method, {kA, kB, kC}, w), corners[k]);
      }
      for (int k = 0; k < 4; ++k)
        check_close(interpolate(method, {kA, kB, kC, kD}, xi[k], eta[k]), corners[k]);
      const Metric on_edge = interpolate(method, kB, kC, 0.4);
      check_close(interpolate(method, {kA, kB, kC}, {0, 0.6, 0.4}), on_edge);
      check_close(interpolate(method, {kA, kB, kC, kD}, 1, 0.4), on_edge);
    }
  }

  TEST_CASE("logarithm and exponential") {
    check_close(logarithm(kA), {1.4813192914240553, 0.56474331004974014, 0.9165759813743152});
    check_close(exponential(logarithm(kA)), kA);
    check_close(exponential({0, 0, 0}), {1, 0, 1});
    check_close(logarithm({1, 0, 1}), {0, 0, 0});
  }

  TEST_CASE("bilinear coordinates of points by hand") {
    const std::array<Point, 4> trapezium{Point{0, 0}, {4, 0}, {2, 2}, {0, 2}};
    const auto [xi, eta] = bilinear_coordinates(trapezium, {1.5, 1});  // width 3 at half height
    CHECK(xi == Approx(0.5).epsilon(1e-15));
    CHECK(eta == Approx(0.5).epsilon(1e-15));
    CHECK(bilinear_coordinates(trapezium, {0, 0}) == std::array<double, 2>{0, 0});
    CHECK(bilinear_coordinates(trapezium, {2, 2}) == std::array<double, 2>{1, 1});
    CHECK(bilinear_coordinates(trapezium, {-1, 1})[0] == 0);  // outside: clamped
    CHECK(bilinear_coordinates(trapezium, {1, 5})[1] == 1);
    CHECK(bilinear_coordinates(trapezium, {9, -3}) == std::array<double, 2>{1, 0});
  }
}

TEST_SUITE("property") {
  TEST_CASE("interpolation keeps its laws on random metrics") {
    std::mt19937_64 random(21);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 3000; ++i) {
      const Metric m1 = random_metric(random, 1000), m2 = random_metric(random, 1000);
      const double t = unit(random);
      for (const Interpolation method : kMethods) {
        const Metric m = interpolate(method, m1, m2, t);
        CHECK(is_positive_definite(m));
        CHECK(interpolate(method, m1, m2, 0) == m1);
        CHECK(interpolate(method, m1, m2, 1) == m2);
        check_close(interpolate(method, m2, m1, 1 - t), m, 1e-6);
        check_close(interpolate(method, m1, m1, t), m1, 1e-11);
      }
    }
  }

  TEST_CASE("the common basis diagonalises both metrics") {
    std::mt19937_64 random(22);
    for (int i = 0; i < 3000; ++i) {
      const Metric m1 = random_metric(random, 1000), m2 = random_metric(random, 1000);
      const SimultaneousReduction r = simultaneous_reduction(m1, m2);
      check_close(metric_from_reduction(r.s1, r.s2, r.mu1, r.mu2), m2, 1e-9);
      check_close(metric_from_reduction(r.s1, r.s2, r.lambda1, r.lambda2), m1, 1e-9);
      const double det_ratio = determinant(m1) / determinant(m2);
      CHECK(r.lambda1 * r.lambda2 == Approx(det_ratio).epsilon(1e-8));
    }
  }

  TEST_CASE("the bilinear map and its inverse agree on convex quadrilaterals") {
    std::mt19937_64 random(23);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 5000; ++i) {
      std::array<Point, 4> quad{Point{0, 0}, {1, 0}, {1, 1}, {0, 1}};
      for (Point& p : quad) p = p + 0.24 * random_point(random);
      for (Point& p : quad) p = {p.x + 0.5 * p.y, 0.01 * p.y};  // thin and sheared
      const double xi = unit(random), eta = unit(random);
      const Point p = lerp(lerp(quad[0], quad[1], xi), lerp(quad[3], quad[2], xi), eta);
      const auto found = bilinear_coordinates(quad, p);
      CHECK(found[0] == Approx(xi).epsilon(1e-11).scale(1));
      CHECK(found[1] == Approx(eta).epsilon(1e-11).scale(1));
    }
  }
}
