#include "mesher/background/background_mesh.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <thread>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "mesher/geometry/predicates.hpp"
#include "mesher/metric/interpolation.hpp"
#include "tests/mesher/metric/random_metric.hpp"
#include "tests/support/meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

Kernel::Point_2 to_cgal(Point p) { return {p.x, p.y}; }

/// A mesh and the CGAL triangulation it consists of.
struct Oracle {
  Mesh mesh;
  Cdt cdt;
  std::map<Triangle, Index> triangle_of;  ///< sorted vertices -> triangle of the mesh

  /// The triangle of the mesh that CGAL finds, kNoIndex outside of the mesh.
  Index locate(Point p) const {
    const Cdt::Face_handle face = cdt.locate(to_cgal(p));
    if (face == nullptr || cdt.is_infinite(face)) return kNoIndex;
    const auto found = triangle_of.find(sorted(face));
    return found == triangle_of.end() ? kNoIndex : found->second;
  }
  static Triangle sorted(Cdt::Face_handle face) {
    Triangle t{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::sort(t.begin(), t.end());
    return t;
  }
};

/// Constrained Delaunay triangulation of points; faces whose centre fails `keep` are left out, so
/// that holes and non-convex domains appear.
template <class Keep>
Oracle triangulate(const std::vector<Point>& points, Keep&& keep) {
  Oracle oracle;
  oracle.mesh.points = points;
  for (std::size_t i = 0; i < points.size(); ++i)
    oracle.cdt.insert(to_cgal(points[i]))->info() = static_cast<Index>(i);
  if (points.size() > 3)
    oracle.cdt.insert_constraint(to_cgal(points[0]), to_cgal(points[points.size() / 2]));
  for (const Cdt::Face_handle face : oracle.cdt.finite_face_handles()) {
    const Triangle t{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    if (!keep((1. / 3) * (points[t[0]] + points[t[1]] + points[t[2]]))) continue;
    oracle.triangle_of[Oracle::sorted(face)] = static_cast<Index>(oracle.mesh.triangles.size());
    oracle.mesh.triangles.push_back(t);
  }
  return oracle;
}

std::vector<Point> random_points(std::mt19937_64& random, int count, Vector scale) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const Point p = random_point(random);
    points.push_back({scale.x * p.x, scale.y * p.y});
  }
  return points;
}

bool in_ring(Point p) {
  const double r = norm(p);
  return r > 0.35 && r < 0.9 && !(p.x > 0 && std::fabs(p.y) < 0.1);  // a C: hole and mouth
}

bool contains(const Mesh& mesh, Index triangle, Point p) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return orientation(mesh.points[a], mesh.points[b], p) >= 0 &&
         orientation(mesh.points[b], mesh.points[c], p) >= 0 &&
         orientation(mesh.points[c], mesh.points[a], p) >= 0;
}

bool any_contains(const Mesh& mesh, Point p) {
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
    if (contains(mesh, t, p)) return true;
  return false;
}

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
      case 0: list.push_back(a); break;
      case 1: list.push_back(lerp(a, b, unit(random))); break;
      case 2: list.push_back(lerp(a, b, 0.5)); break;
      case 3: list.push_back(lerp(a, b, 3 * unit(random) - 1)); break;
      case 4: list.push_back(i % 60 == 4 ? 1e6 * p : a + 1e-13 * p); break;
      default: list.push_back({scale.x * p.x, scale.y * p.y});
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
    for (const Metric& bad : {Metric{1, 2, 1}, Metric{-1, 0, -1}, Metric{0, 0, 0}, Metric{1, nan, 1},
                              Metric{infinity, 0, 1}}) {
      const std::string text = message(bad);
      CHECK(text.find("vertex 6 (10.0") != std::string::npos);
      CHECK(text.find("not positive definite") != std::string::npos);
    }
    CHECK(message({1, 0.5, 1}).empty());
    CHECK_THROWS_AS(BackgroundMesh(mesh, MetricField(12)), InputError);
    CHECK_THROWS_AS(BackgroundMesh(Mesh{{{0, 0}}, {}, {}, {}, {}, {}, {}, {}, {}, {}}, {Metric{}}),
                    InputError);
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

  TEST_CASE("the metric as a function can be copied") {
    const Mesh mesh = crossed_square(2, 1);
    const MetricFunction f = background_metric(mesh, MetricField(mesh.points.size(), Metric{4, 1, 9}));
    const MetricFunction g = f;
    CHECK(difference(f({0.3, 0.4}), {4, 1, 9}) < 1e-14);
    CHECK(difference(g({7, -2}), {4, 1, 9}) < 1e-14);
  }
}
