#include "mesher/front/ideal_point.hpp"

#include <random>

#include <doctest/doctest.h>

#include "mesher/front/paper_formation.hpp"
#include "tests/mesher/metric/random_metric.hpp"
#include "tests/support/meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

constexpr double kSqrt3 = 1.7320508075688772;

/// v turned in the metric by way of the normalised space: M^(-1/2) R M^(1/2) v, eigenvectors first.
Vector turned(const Metric& m, Vector v, double angle) {
  const PrincipalAxes axes = principal_axes(m);
  const double s = dot(v, axes.e1) / axes.h1, t = dot(v, axes.e2) / axes.h2;
  const double c = std::cos(angle), d = std::sin(angle);
  return (c * s - d * t) * axes.h1 * axes.e1 + (d * s + c * t) * axes.h2 * axes.e2;
}

Vector unit(const Metric& m, Vector v) { return (1 / std::sqrt(dot(v, m * v))) * v; }

struct Sample {
  Metric m;
  Point a, b;
};
Sample random_sample(std::mt19937_64& random) {
  return {random_metric(random, 50), random_point(random), random_point(random)};
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("C1 is AB turned by 60 degrees about A with unit length there (Eqn 23b)") {
    std::mt19937_64 random(1);
    for (int i = 0; i < 300; ++i) {
      const auto [m, a, b] = random_sample(random);
      const Point c = offset_from_a(m, a, b);
      const Point expected = a + turned(m, unit(m, b - a), M_PI / 3);
      CHECK(length(m, c - expected) < 1e-10);
      CHECK(length(m, c - a) == doctest::Approx(1).epsilon(1e-10));
      CHECK(cross(b - a, c - a) > 0);
    }
  }

  TEST_CASE("C2 is BA turned by -60 degrees about B with unit length there (A14)") {
    std::mt19937_64 random(2);
    for (int i = 0; i < 300; ++i) {
      const auto [m, a, b] = random_sample(random);
      const Point c = offset_from_b(m, a, b);
      const Point expected = b + turned(m, unit(m, a - b), -M_PI / 3);
      CHECK(length(m, c - expected) < 1e-10);
      CHECK(length(m, c - b) == doctest::Approx(1).epsilon(1e-10));
      CHECK(cross(b - a, c - a) > 0);
    }
  }

  TEST_CASE("C3 is DB turned by 90 degrees about D with length sqrt3 / 2 there (A15)") {
    std::mt19937_64 random(3);
    for (int i = 0; i < 300; ++i) {
      const auto [m, d, b] = random_sample(random);
      const Point c = offset_from_midpoint(m, d, b);
      const Point expected = d + 0.5 * kSqrt3 * turned(m, unit(m, b - d), M_PI / 2);
      CHECK(length(m, c - expected) < 1e-10);
      CHECK(length(m, c - d) == doctest::Approx(0.866025403784).epsilon(1e-10));
      CHECK(std::fabs(inner_product(m, c - d, unit(m, b - d))) < 1e-9);
    }
  }

  TEST_CASE("all three offsets and the first guess agree over a unit base in a constant metric") {
    std::mt19937_64 random(4);
    for (int i = 0; i < 100; ++i) {
      const auto [m, a, far] = random_sample(random);
      const Point b = a + unit(m, far - a);
      const Point c = offset_from_a(m, a, b);
      CHECK(length(m, offset_from_b(m, a, b) - c) < 1e-10);
      CHECK(length(m, offset_from_midpoint(m, lerp(a, b, 0.5), b) - c) < 1e-10);
      CHECK(length(m, constant_metric_apex(factor_of(m), a, b) - c) < 1e-9);
    }
  }

  TEST_CASE("the Euclidean equilateral triangle is found") {
    const Point c = offset_from_a({1, 0, 1}, {0, 0}, {1, 0});
    CHECK(c.x == doctest::Approx(0.5));
    CHECK(c.y == doctest::Approx(0.5 * kSqrt3));
  }

  TEST_CASE("the first guess has unit sides over bases of length 0.5 to 1.6") {
    std::mt19937_64 random(5);
    for (int i = 0; i < 100; ++i) {
      const auto [m, a, far] = random_sample(random);
      const double base = 0.5 + 0.011 * i;
      const Point b = a + base * unit(m, far - a);
      const Point c = constant_metric_apex(factor_of(m), a, b);
      CHECK(length(m, c - a) == doctest::Approx(1).epsilon(1e-9));
      CHECK(length(m, c - b) == doctest::Approx(1).epsilon(1e-9));
    }
  }

  TEST_CASE("over very long bases the first guess keeps a height") {
    const Point c = constant_metric_apex({1, 0, 1}, {0, 0}, {8, 0});
    CHECK(c.x == doctest::Approx(4));
    CHECK(c.y > 0.5);
    CHECK(c.y < 0.6);
  }

  TEST_CASE("Newton reaches unit lengths in a graded metric (Eqn 22)") {
    // Size 0.2 + 0.3 y: linear, so the exact length of a segment is the log mean of its ends.
    const auto h = [](Point p) { return 0.2 + 0.3 * p.y; };
    const Mesh mesh = crossed_square(4, 4);
    const BackgroundMesh background(mesh,
                                    sample(mesh, [&](Point p) { return metric_from_size(h(p)); }));
    const auto exact_length = [&](Point p, Point q) {
      const double x = h(p), y = h(q);
      return norm(q - p) * (std::fabs(x - y) < 1e-9 ? 1 / x : std::log(y / x) / (y - x));
    };
    const auto vertex = [&](Point p) {
      Index hint = 0;
      const MetricFactor r = background.factor_at(p, hint);
      return WorkVertex{p, r, hint};
    };
    std::mt19937_64 random(6);
    for (int i = 0; i < 100; ++i) {
      const Point a = Point{2, 2} + random_point(random);
      const double phi = 0.0628 * i;
      const WorkVertex va = vertex(a), vb = vertex(a + h(a) * Vector{std::cos(phi), std::sin(phi)});
      TrialPoint trial{constant_metric_apex(va.r, va.p, vb.p), {}, va.hint};
      trial.r = background.factor_at(trial.p, trial.hint);
      correct_by_newton(background, va, vb, 5, trial);
      CHECK(exact_length(va.p, trial.p) == doctest::Approx(1).epsilon(0.03));
      CHECK(exact_length(vb.p, trial.p) == doctest::Approx(1).epsilon(0.03));
      CHECK(cross(vb.p - va.p, trial.p - va.p) > 0);
      Index hint = 0;
      CHECK(trial.r.a == doctest::Approx(background.factor_at(trial.p, hint).a));
    }
  }

  TEST_CASE("the quality of the fast path is one for unit triangles and falls off them") {
    const WorkVertex a{{0, 0}, {1, 0, 1}, 0}, b{{1, 0}, {1, 0, 1}, 0};
    CHECK(fast_mu(a, b, {0.5, 0.5 * kSqrt3}, {1, 0, 1}) == doctest::Approx(1));
    CHECK(fast_mu(a, b, {0.5, 0.3}, {1, 0, 1}) < 0.7);
    CHECK(fast_mu(a, b, {0.5, -0.8}, {1, 0, 1}) < 0);
    CHECK(fast_mu(a, b, {0.5, 0}, {1, 0, 1}) < 0);
    // Twice the size: sides of length 2, e^-delta with delta = 2/3 of |l - 1| over the new sides.
    const double mu =
        fast_mu({{0, 0}, {2, 0, 2}, 0}, {{1, 0}, {2, 0, 2}, 0}, {0.5, 0.5 * kSqrt3}, {2, 0, 2});
    CHECK(mu == doctest::Approx(std::exp(-2. / 3)).epsilon(0.1));
  }

  TEST_CASE("the paper's offset is the one of the three with the highest mu") {
    const Mesh mesh = crossed_square(4, 4);
    const MetricFunction metric = [](Point p) {
      return metric_from_sizes(0.3 + 0.2 * p.y, 0.6 + 0.1 * p.x, {1, 1});
    };
    const BackgroundMesh background(mesh, sample(mesh, metric),
                                    Interpolation::simultaneous_reduction);
    Index hint = 0;
    const auto vertex = [&](Point p) { return WorkVertex{p, background.factor_at(p, hint), hint}; };
    const WorkVertex a = vertex({1.5, 1.5}), b = vertex({2.0, 1.7});
    const PaperOffset offset = paper_offset(background, a, b);
    const double half1 = paper_length(background, a, vertex(offset.midpoint));
    const double half2 = paper_length(background, vertex(offset.midpoint), b);
    CHECK(half1 == doctest::Approx(half2).epsilon(0.02));
    const double best = paper_mu(background, a, b, offset.best);
    int equal = 0;
    for (const Point c :
         {offset_from_a(metric_of(a.r), a.p, b.p), offset_from_b(metric_of(b.r), a.p, b.p),
          offset_from_midpoint(background.metric_at(offset.midpoint, hint), offset.midpoint,
                               b.p)}) {
      const WorkVertex v = vertex(c);
      CHECK(paper_mu(background, a, b, {v.p, v.r, v.hint}) <= best + 1e-9);
      equal += norm(c - offset.best.p) < 1e-9 ? 1 : 0;
    }
    CHECK(equal >= 1);
  }
}
