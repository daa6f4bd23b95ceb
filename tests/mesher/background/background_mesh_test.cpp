#include "mesher/background/background_mesh.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <thread>

#include <doctest/doctest.h>

#include "tests/support/delaunay.hpp"
#include "tests/support/meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Random, on vertices, on edges (rounded), on lines through edges, far away.
std::vector<Point> queries(const Mesh& mesh, std::mt19937_64& random, int count, Vector scale) {
  std::uniform_int_distribution<std::size_t> pick(0, mesh.triangles.size() - 1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Point> list;
  for (int i = 0; i < count; ++i) {
    const Point p = 1.3 * random_point(random);
    const auto& t = mesh.triangles[pick(random)];
    const Point a = mesh.points[t[0]], b = mesh.points[t[1]];
    switch (i % 6) {
      case 0:
        list.push_back(a);
        break;
      case 1:
        list.push_back(lerp(a, b, unit(random)));
        break;
      case 2:
        list.push_back(lerp(a, b, 0.5));
        break;
      case 3:
        list.push_back(lerp(a, b, 3 * unit(random) - 1));
        break;
      case 4:
        list.push_back(i % 60 == 4 ? 1e6 * p : a + 1e-13 * p);
        break;
      default:
        list.push_back({scale.x * p.x, scale.y * p.y});
    }
  }
  return list;
}

struct Tally {
  int queries = 0, inside = 0, wrong = 0, against_cgal = 0, against_brute_force = 0;
};

/// Location with the last place as hint, against CGAL and, on every `brute`-th query, all
/// triangles.
Tally compare(const Oracle& oracle, const std::vector<Point>& points, int brute) {
  const BackgroundMesh background(oracle.mesh, MetricField(oracle.mesh.points.size()));
  Tally tally;
  Index hint = 0;
  for (const Point p : points) {
    const Index found = background.locate(p, hint);
    if (found != kNoIndex && !contains(oracle.mesh, found, p)) ++tally.wrong;
    // Where p lies on an edge CGAL may answer with a face that is not in the mesh.
    const Index cgal = oracle.locate(p);
    if (cgal != kNoIndex && found == kNoIndex) ++tally.against_cgal;
    if (cgal == kNoIndex && found != kNoIndex && !any_contains(oracle.mesh, p))
      ++tally.against_cgal;
    if (tally.queries++ % brute == 0 && any_contains(oracle.mesh, p) != (found != kNoIndex))
      ++tally.against_brute_force;
    if (found == kNoIndex) continue;
    hint = found;
    ++tally.inside;
  }
  return tally;
}

void check_location(const Oracle& oracle, std::mt19937_64& random, int count, Vector scale) {
  const std::vector<Point> points = queries(oracle.mesh, random, count, scale);
  const Tally tally = compare(oracle, points, 8);
  CHECK(tally.queries == count);
  CHECK(tally.inside > count / 4);
  CHECK(tally.inside < count);
  CHECK(tally.wrong == 0);
  CHECK(tally.against_cgal == 0);
  CHECK(tally.against_brute_force == 0);
}

Point nearest_by_brute_force(const Mesh& mesh, Point p) {
  if (any_contains(mesh, p)) return p;
  Point best{1e300, 1e300};
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Point a = mesh.points[t[k]], u = mesh.points[t[(k + 1) % 3]] - a;
      const Point q = a + std::clamp(dot(p - a, u) / squared_norm(u), 0., 1.) * u;
      if (norm(q - p) < norm(best - p)) best = q;
    }
  return best;
}

double difference(const Metric& x, const Metric& y) {
  const double scale = std::max(std::fabs(y.m11), std::fabs(y.m22));
  return std::max({std::fabs(x.m11 - y.m11), std::fabs(x.m12 - y.m12), std::fabs(x.m22 - y.m22)}) /
         scale;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("location agrees with CGAL and brute force on 1e5 random and degenerate queries") {
    std::mt19937_64 random(1);
    SUBCASE("a convex cloud") {
      const auto oracle =
          triangulate(random_points(random, 150, {1, 1}), [](Point) { return true; });
      check_location(oracle, random, 40000, {1, 1});
    }
    SUBCASE("a domain with a hole and a mouth") {
      const auto oracle = triangulate(random_points(random, 400, {1, 1}), in_ring);
      check_location(oracle, random, 30000, {1, 1});
    }
    SUBCASE("stretched 1 to 1e4") {
      const auto oracle = triangulate(random_points(random, 150, {1, 1e-4}),
                                      [](Point p) { return p.x < 0 || p.y < 2e-5; });
      check_location(oracle, random, 30000, {1, 1e-4});
    }
    SUBCASE("a lattice full of collinear and cocircular points") {
      std::vector<Point> points;
      for (int j = 0; j < 12; ++j)
        for (int i = 0; i < 12; ++i) points.push_back({i / 6. - 1, j / 6. - 1});
      const auto oracle = triangulate(points, [](Point p) { return norm(p) > 0.4; });
      check_location(oracle, random, 30000, {1, 1});
    }
  }

  TEST_CASE("any hint leads to the same answer") {
    std::mt19937_64 random(2);
    const Oracle oracle = triangulate(random_points(random, 300, {1, 1}), in_ring);
    const BackgroundMesh background(oracle.mesh, MetricField(oracle.mesh.points.size()));
    for (int i = 0; i < 300; ++i) {
      const Point p = random_point(random);
      const bool inside = any_contains(oracle.mesh, p);
      for (Index hint = 0; hint < background.triangle_count(); hint += 37)
        CHECK((background.locate(p, hint) != kNoIndex) == inside);
    }
  }

  TEST_CASE("the nearest point outside agrees with brute force and is the point itself inside") {
    std::mt19937_64 random(3);
    for (const Vector scale : {Vector{1, 1}, Vector{1, 1e-3}}) {
      const auto keep = [&](Point p) { return in_ring({p.x / scale.x, p.y / scale.y}); };
      const Oracle oracle = triangulate(random_points(random, 300, scale), keep);
      const BackgroundMesh background(oracle.mesh, MetricField(oracle.mesh.points.size()));
      for (const Point p : queries(oracle.mesh, random, 3000, scale)) {
        const auto nearest = background.nearest(p);
        const Point expected = nearest_by_brute_force(oracle.mesh, p);
        CHECK(norm(nearest.point - p) ==
              doctest::Approx(norm(expected - p)).epsilon(1e-12).scale(1));
        REQUIRE(nearest.triangle != kNoIndex);
      }
    }
  }

  TEST_CASE("the numbering of a large mesh does not change the metric") {
    const Mesh mesh = crossed_square(110, 1);
    REQUIRE(mesh.points.size() > 20000);
    const auto metric = [](Point p) {
      return metric_from_sizes(0.1 + p.x, 0.2 + p.y, {1 + p.x, p.y});
    };
    Mesh shuffled = mesh;
    std::mt19937_64 random(7);
    std::vector<Index> number(mesh.points.size());
    std::iota(number.begin(), number.end(), Index{0});
    std::shuffle(number.begin(), number.end(), random);
    for (std::size_t v = 0; v < number.size(); ++v) shuffled.points[number[v]] = mesh.points[v];
    for (Triangle& t : shuffled.triangles)
      for (Index& v : t) v = number[v];
    std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);
    const BackgroundMesh plain(mesh, sample(mesh, metric));
    const BackgroundMesh mixed(shuffled, sample(shuffled, metric));
    Index hint1 = 0, hint2 = 0;
    for (int i = 0; i < 2000; ++i) {
      const Point p = random_point(random);
      const Metric m = plain.metric_at(p, hint1);
      CHECK(difference(mixed.metric_at(p, hint2), m) < 1e-12);
      const Index found = mixed.locate(p);
      if (found != kNoIndex) CHECK(contains(shuffled, mixed.element_of(found), p));
      CHECK((found == kNoIndex) == (plain.locate(p) == kNoIndex));
    }
  }

  TEST_CASE("look-ups from several threads give what one thread gives") {
    std::mt19937_64 random(8);
    const Oracle oracle = triangulate(random_points(random, 300, {1, 1}), in_ring);
    const auto field = sample(oracle.mesh, [&](Point) { return random_metric(random, 10); });
    const BackgroundMesh alone(oracle.mesh, field), shared(oracle.mesh, field);
    std::vector<Point> points = random_points(random, 4000, {1.5, 1.5});
    std::vector<Metric> expected;
    for (const Point p : points) {
      Index hint = 0;
      expected.push_back(alone.metric_at(p, hint));
    }
    std::array<int, 4> wrong{};
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < wrong.size(); ++k)
      threads.emplace_back([&, k] {
        for (std::size_t i = 0; i < points.size(); ++i) {
          Index hint = 0;
          if (shared.metric_at(points[i], hint) != expected[i]) ++wrong[k];
        }
      });
    for (std::thread& thread : threads) thread.join();
    CHECK(wrong == std::array<int, 4>{});
  }
}
