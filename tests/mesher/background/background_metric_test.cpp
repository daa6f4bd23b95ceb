#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "mesher/background/background_mesh.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/metric/interpolation.hpp"
#include "tests/support/delaunay.hpp"
#include "tests/support/meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

double difference(const Metric& x, const Metric& y) {
  const double scale = std::max(std::fabs(y.m11), std::fabs(y.m22));
  return std::max({std::fabs(x.m11 - y.m11), std::fabs(x.m12 - y.m12), std::fabs(x.m22 - y.m22)}) /
         scale;
}

/// Point of the triangle at random barycentric coordinates.
struct Inside {
  std::array<double, 3> weights;
  Point p;
};
Inside random_inside(const Mesh& mesh, Index triangle, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.02, 1);
  std::array<double, 3> w{unit(random), unit(random), unit(random)};
  const double sum = w[0] + w[1] + w[2];
  Point p{0, 0};
  for (int k = 0; k < 3; ++k) {
    w[k] /= sum;
    p = p + w[k] * mesh.points[mesh.triangles[triangle][k]];
  }
  return {w, p};
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a constant metric is reproduced inside and outside by all interpolations") {
    std::mt19937_64 random(4);
    const Mesh mesh = crossed_square(3, 1);
    for (const auto method : {Interpolation::linear_size, Interpolation::simultaneous_reduction,
                              Interpolation::log_euclidean}) {
      const Metric m = metric_from_sizes(0.1, 0.7, {1, 2});
      const BackgroundMesh background(mesh, MetricField(mesh.points.size(), m), method);
      Index hint = 0;
      for (int i = 0; i < 200; ++i) {
        const Point p = 3 * random_point(random);
        CHECK(difference(background.metric_at(p, hint), m) < 1e-12);
        CHECK(difference(metric_of(background.factor_at(p, hint)), m) < 1e-12);
      }
      CHECK(background.complexity() == doctest::Approx(1 / 0.07));  // 1 / (h1 h2)
    }
  }

  TEST_CASE("linear sizes are reproduced by the linear interpolation") {
    std::mt19937_64 random(5);
    const Oracle oracle =
        triangulate(random_points(random, 200, {1, 1}), [](Point) { return true; });
    const auto h = [](Point p) { return 0.5 + 0.2 * p.x - 0.1 * p.y; };
    const auto field = sample(oracle.mesh, [&](Point p) { return metric_from_size(h(p)); });
    const BackgroundMesh background(oracle.mesh, field);
    Index hint = 0;
    for (Index t = 0; t < background.triangle_count(); ++t) {
      const Point p = random_inside(oracle.mesh, t, random).p;
      CHECK(1 / background.factor_at(p, hint).a == doctest::Approx(h(p)).epsilon(1e-13));
      CHECK(difference(background.metric_at(p, hint), metric_from_size(h(p))) < 1e-12);
    }
  }

  TEST_CASE("triangles are interpolated as the three rules say") {
    std::mt19937_64 random(6);
    const Oracle oracle =
        triangulate(random_points(random, 100, {1, 1}), [](Point) { return true; });
    const auto field = sample(oracle.mesh, [&](Point) { return random_metric(random, 30); });
    for (const auto method : {Interpolation::linear_size, Interpolation::simultaneous_reduction,
                              Interpolation::log_euclidean}) {
      const BackgroundMesh background(oracle.mesh, field, method);
      Index hint = 0;
      for (Index t = 0; t < background.triangle_count(); ++t) {
        const auto [weights, p] = random_inside(oracle.mesh, t, random);
        const Triangle& v = oracle.mesh.triangles[t];
        const Metric expected =
            interpolate(method, {field[v[0]], field[v[1]], field[v[2]]}, weights);
        CHECK(difference(background.metric_at(p, hint), expected) < 1e-6);
        CHECK(difference(metric_of(background.factor_at(p, hint)), expected) < 1e-6);
      }
    }
  }

  TEST_CASE("quadrilaterals are walked as two triangles and interpolated bilinearly") {
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}, {3, 0.5}};
    mesh.triangles = {{2, 6, 5}};
    mesh.quads = {{0, 1, 4, 3}, {1, 2, 5, 4}};
    // Size 1 + x y: linear along every edge, bilinear inside, not linear in any triangle.
    const auto h = [](Point p) { return 1 + p.x * p.y; };
    const auto field = sample(mesh, [&](Point p) { return metric_from_size(h(p)); });
    const BackgroundMesh background(mesh, field);
    CHECK(background.triangle_count() == 5);
    CHECK(background.element_of(background.locate({2.4, 0.5})) == 0);
    CHECK(background.element_of(background.locate({0.7, 0.2})) == 1);
    CHECK(background.element_of(background.locate({0.2, 0.7})) == 1);
    CHECK(background.element_of(background.locate({1.9, 0.9})) == 2);
    Index hint = 0;
    for (const Point p : {Point{0.25, 0.75}, Point{0.75, 0.25}, Point{0.5, 0.5}, Point{1.3, 0.9}}) {
      CHECK(difference(background.metric_at(p, hint), metric_from_size(h(p))) < 1e-12);
      CHECK(difference(metric_of(background.factor_at(p, hint)), metric_from_size(h(p))) < 1e-12);
    }
  }

  TEST_CASE("bad metrics are refused with vertex and place") {
    const Mesh mesh = crossed_square(2, 10);
    const auto message = [&](const Metric& bad) {
      MetricField field(mesh.points.size());
      field[5] = bad;  // vertex 6 of the file at (10, 5)
      try {
        const BackgroundMesh background(mesh, field);
      } catch (const InputError& error) {
        return std::string(error.what());
      }
      return std::string();
    };
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    for (const Metric& bad : {Metric{1, 2, 1}, Metric{-1, 0, -1}, Metric{0, 0, 0},
                              Metric{1, nan, 1}, Metric{infinity, 0, 1}}) {
      const std::string text = message(bad);
      CHECK(text.find("vertex 6 (10.0") != std::string::npos);
      CHECK(text.find("not positive definite") != std::string::npos);
    }
    CHECK(message({1, 0.5, 1}).empty());
    CHECK_THROWS_AS(BackgroundMesh(mesh, MetricField(12)), InputError);
    CHECK_THROWS_AS(BackgroundMesh(Mesh{{{0, 0}}, {}, {}, {}, {}, {}, {}, {}, {}, {}}, {Metric{}}),
                    InputError);
  }

  TEST_CASE("the size factor multiplies all sizes of the field") {
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}, {3, 0.5}};
    mesh.triangles = {{2, 6, 5}, {0, 1, 4}, {0, 4, 3}};
    mesh.quads = {{1, 2, 5, 4}};
    const MetricField field(mesh.points.size(), metric_from_sizes(0.1, 0.5, {1, 0}));
    for (const auto method : {Interpolation::linear_size, Interpolation::simultaneous_reduction,
                              Interpolation::log_euclidean}) {
      BackgroundMesh background(mesh, field, method);
      CHECK(background.size_factor() == 1);
      background.set_size_factor(3);
      Index hint = 0;
      for (const Point p : {Point{0.7, 0.2}, Point{1.4, 0.3}, Point{2.5, 0.5}, Point{-4, 9}}) {
        const Metric expected = metric_from_sizes(0.3, 1.5, {1, 0});
        CHECK(difference(background.metric_at(p, hint), expected) < 1e-13);
        CHECK(difference(metric_of(background.factor_at(p, hint)), expected) < 1e-13);
      }
      // The area is 2.5.
      CHECK(background.complexity() == doctest::Approx(2.5 / (0.3 * 1.5)));
    }
  }

  TEST_CASE("size factors that are powers of two are exact and 1 gives the field back") {
    std::mt19937_64 random(9);
    const Oracle oracle =
        triangulate(random_points(random, 60, {1, 1}), [](Point) { return true; });
    const auto field = sample(oracle.mesh, [&](Point) { return random_metric(random, 30); });
    for (const auto method : {Interpolation::linear_size, Interpolation::simultaneous_reduction,
                              Interpolation::log_euclidean}) {
      const BackgroundMesh plain(oracle.mesh, field, method);
      BackgroundMesh scaled_sizes(oracle.mesh, field, method);
      for (const double factor : {4., 0.3, 2., 1.}) {
        scaled_sizes.set_size_factor(factor);
        if (factor < 1) continue;  // 0.3 rounds, and must leave no trace
        Index hint1 = 0, hint2 = 0;
        for (Index t = 0; t < plain.triangle_count(); ++t) {
          const Point p = random_inside(oracle.mesh, t, random).p;
          const MetricFactor r = plain.factor_at(p, hint1);
          const MetricFactor s = scaled_sizes.factor_at(p, hint2);
          CHECK((s.a * factor == r.a && s.b * factor == r.b && s.c * factor == r.c));
          const Metric m = scaled_sizes.metric_at(p, hint2);
          CHECK(scaled(m, factor * factor) == plain.metric_at(p, hint1));
        }
        CHECK(scaled_sizes.complexity() * factor * factor == plain.complexity());
      }
    }
  }

  TEST_CASE("size factors that are not positive numbers are refused") {
    const Mesh mesh = crossed_square(2, 1);
    BackgroundMesh background(mesh, MetricField(mesh.points.size()));
    for (const double bad : {0., -1., std::nan(""), std::numeric_limits<double>::infinity()})
      CHECK_THROWS_AS(background.set_size_factor(bad), InputError);
    CHECK(background.size_factor() == 1);
  }

  TEST_CASE("the metric as a function can be copied") {
    const Mesh mesh = crossed_square(2, 1);
    const MetricFunction f =
        background_metric(mesh, MetricField(mesh.points.size(), Metric{4, 1, 9}));
    const MetricFunction g = f;
    CHECK(difference(f({0.3, 0.4}), {4, 1, 9}) < 1e-14);
    CHECK(difference(g({7, -2}), {4, 1, 9}) < 1e-14);
  }
}
