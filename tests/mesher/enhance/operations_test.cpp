#include <algorithm>
#include <random>

#include <doctest/doctest.h>

#include "mesher/enhance/collapse.hpp"
#include "mesher/enhance/required_points.hpp"
#include "mesher/enhance/split.hpp"
#include "mesher/enhance/swap.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/metric/quality.hpp"
#include "tests/support/work_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Two triangles 0 1 2 and 1 3 2 inside of four segments; the diagonal is 1-2, opposite vertex 0
/// of triangle 0.
struct TwoTriangles {
  Mesh grid = crossed_rectangle(4, 4, {-5, -5}, {5, 5});
  BackgroundMesh background;
  WorkMesh mesh;
  Patch patch;

  explicit TwoTriangles(const std::array<Point, 4>& p, const MetricFunction& metric)
      : background(grid, sample(grid, metric)),
        mesh(make(p)),
        patch(make_patch(background, mesh, {})) {}

 private:
  WorkMesh make(const std::array<Point, 4>& p) const {
    WorkMesh m;
    for (const Point q : p) {
      Index hint = 0;
      const MetricFactor r = background.factor_at(q, hint);
      m.vertices.push_back({q, r, hint});
    }
    const Index around[] = {0, 1, 3, 2};
    for (Index k = 0; k < 4; ++k)
      m.segments.push_back({around[k], around[(k + 1) % 4], 0, 1. * k, k + 1., 0, kNoIndex});
    m.triangles = {{{0, 1, 2}, {1, ~3, ~0}}, {{1, 3, 2}, {~2, 0, ~1}}};
    return m;
  }
};

const MetricFunction kUnit = [](Point) { return Metric{}; };

/// A filled square of about 200 triangles under a random metric.
struct Filled {
  WorkCase work;
  Patch patch;
  explicit Filled(unsigned seed, const Domain& domain = square_domain(1))
      : work(make(seed, domain)), patch(make_patch(*work.background, work.mesh(), {})) {}

  static WorkCase make(unsigned seed, const Domain& domain) {
    std::mt19937_64 random(seed);
    WorkCase work(domain, RandomMetric{&random, 0.12, 30}, {0, 0}, {1, 1});
    work.advance();
    return work;
  }
};

std::vector<Segment> segments_of(const WorkMesh& mesh) { return mesh.segments; }

bool same(const std::vector<Segment>& x, const std::vector<Segment>& y) {
  return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](const Segment& s, const Segment& t) {
    return s.a == t.a && s.b == t.b && s.parameter_a == t.parameter_a &&
           s.parameter_b == t.parameter_b;
  });
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the diagonal is swapped when the product of the alphas grows (Fig. 6)") {
    // A rhombus with the long diagonal 1-2 as edge: alpha of each half 0.59 (before), 0.97 (after).
    TwoTriangles bad({{{0, -0.6}, {1, 0}, {-1, 0}, {0, 0.6}}}, kUnit);
    CHECK(try_swap(bad.patch, 0, 0, SwapCriterion::product));
    CHECK(broken_invariant(bad.patch) == "");
    CHECK(bad.patch.statistics.swaps == 1);
    for (Index t = 0; t < 2; ++t) {
      const auto& v = bad.mesh.triangles[t].vertices;
      CHECK(std::count(v.begin(), v.end(), 0) + std::count(v.begin(), v.end(), 3) == 2);
      CHECK(bad.patch.alpha[t] == doctest::Approx(bad.patch.alpha_of(t)));
    }
    CHECK_FALSE(try_swap(bad.patch, 0, 0, SwapCriterion::product));
    for (int k = 0; k < 3; ++k) CHECK_FALSE(try_swap(bad.patch, 1, k, SwapCriterion::minimum));
  }

  TEST_CASE("the metric decides which diagonal is better") {
    const std::array<Point, 4> rhombus{{{0, -0.6}, {1, 0}, {-1, 0}, {0, 0.6}}};
    TwoTriangles stretched(rhombus, [](Point) { return metric_from_sizes(3, 0.5, {1, 0}); });
    CHECK_FALSE(try_swap(stretched.patch, 0, 0, SwapCriterion::product));
    CHECK_FALSE(try_swap(stretched.patch, 0, 0, SwapCriterion::minimum));
  }

  TEST_CASE("product and minimum are different criteria") {
    // Found by search: after the swap the worse triangle is worse but the product is larger.
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    int different = 0;
    for (int i = 0; i < 2000; ++i) {
      const std::array<Point, 4> p{{{0.5 * unit(random), -1 + 0.5 * unit(random)},
                                    {1 + 0.5 * unit(random), 0.5 * unit(random)},
                                    {-1 + 0.5 * unit(random), 0.5 * unit(random)},
                                    {0.5 * unit(random), 1 + 0.5 * unit(random)}}};
      const auto a = [&](int x, int y, int z) {
        return alpha(std::array<Metric, 3>{}, {p[x], p[y], p[z]});
      };
      const double old1 = a(0, 1, 2), old2 = a(1, 3, 2), new1 = a(0, 1, 3), new2 = a(0, 3, 2);
      if (std::min({old1, old2}) <= 0) continue;
      const bool valid = new1 > 0 && new2 > 0;
      const bool product = valid && new1 * new2 > old1 * old2;
      const bool minimum = valid && std::min(new1, new2) > std::min(old1, old2);
      TwoTriangles x(p, kUnit), y(p, kUnit);
      CHECK(try_swap(x.patch, 0, 0, SwapCriterion::product) == product);
      CHECK(try_swap(y.patch, 0, 0, SwapCriterion::minimum) == minimum);
      CHECK(broken_invariant(x.patch) == "");
      different += product != minimum ? 1 : 0;
    }
    CHECK(different > 10);
  }

  TEST_CASE("a swap never inverts a triangle and never touches a segment") {
    TwoTriangles dart({{{0, -1}, {-0.2, 0}, {-1, 1}, {0, 1}}}, kUnit);  // concave at 1
    REQUIRE(broken_invariant(dart.patch) == "");
    CHECK_FALSE(force_swap(dart.patch, 0, 0));
    TwoTriangles flat({{{0, -1}, {1, 0}, {-1, 0}, {2, 1}}}, kUnit);  // 0, 1 and 3 on a line
    CHECK_FALSE(force_swap(flat.patch, 0, 0));
    TwoTriangles good({{{0, -1}, {1, 0}, {-1, 0}, {0, 1}}}, kUnit);
    CHECK_FALSE(force_swap(good.patch, 0, 1));
    CHECK_FALSE(force_swap(good.patch, 0, 2));
    CHECK(force_swap(good.patch, 0, 0));
    CHECK(broken_invariant(good.patch) == "");
  }

  TEST_CASE("swapping everywhere keeps the mesh valid and raises the product of the alphas") {
    for (unsigned seed = 0; seed < 5; ++seed) {
      Filled filled(seed);
      const auto log_product = [&] {
        double sum = 0;
        for (Index t = 0; t < static_cast<Index>(filled.patch.mesh.triangles.size()); ++t)
          sum += std::log(filled.patch.alpha_of(t));
        return sum;
      };
      const double before = log_product();
      swap_all(filled.patch, SwapCriterion::product, 1);
      CHECK(broken_invariant(filled.patch) == "");
      CHECK(log_product() >= before);
      const std::int64_t swaps = filled.patch.statistics.swaps;
      swap_all(filled.patch, SwapCriterion::product, 1);
      CHECK(filled.patch.statistics.swaps == swaps);
    }
  }

  TEST_CASE("collapses keep the mesh valid and fixed vertices in place") {
    for (unsigned seed = 0; seed < 5; ++seed) {
      Filled filled(seed);
      Patch& patch = filled.patch;
      const auto vertices = static_cast<Index>(patch.mesh.vertices.size());
      const auto segments = segments_of(patch.mesh);
      std::mt19937_64 random(seed);
      Index triangles = live_triangles(patch.mesh);
      for (int i = 0; i < 400; ++i) {
        const auto t = static_cast<Index>(random() % patch.mesh.triangles.size());
        if (patch.mesh.triangles[t].dead()) continue;
        const Index a = patch.mesh.triangles[t].vertices[i % 3];
        const Index b = patch.mesh.triangles[t].vertices[(i + 1) % 3];
        const Point before = patch.point(b);
        const bool done = collapse(patch, a, b, 10, 0);
        CHECK_FALSE((done && patch.fixed[a]));
        CHECK(patch.point(b) == before);
        if (done) {
          triangles -= 2;
          CHECK(patch.triangle_of[a] == kNoIndex);
          REQUIRE(broken_invariant(patch) == "");
        }
      }
      CHECK(patch.statistics.collapses > 10);
      CHECK(live_triangles(patch.mesh) == triangles);
      CHECK(area_of(patch.mesh) == doctest::Approx(1).epsilon(1e-12));
      CHECK(same(patch.mesh.segments, segments));
      for (Index v = 0; v < vertices; ++v)
        if (patch.fixed[v]) CHECK(patch.triangle_of[v] != kNoIndex);
    }
  }

  TEST_CASE("a collapse respects its limits") {
    Filled filled(1);
    Patch& patch = filled.patch;
    const WorkMesh before = patch.mesh;
    for (const WorkTriangle& t : before.triangles)
      for (int k = 0; k < 3; ++k)
        CHECK_FALSE(collapse(patch, t.vertices[k], t.vertices[kNext[k]], 1e-3, 0));
    CHECK(patch.statistics.collapses == 0);
  }

  TEST_CASE("a vertex with three neighbours is not collapsed: the link condition fails") {
    // One vertex inside of a triangle: collapsing it would leave one triangle twice.
    TwoTriangles two({{{0, -1}, {1, 0}, {-1, 0}, {0, 1}}}, kUnit);
    const Index v = insert_vertex(two.patch, 0, {0, -0.3});
    // Swaps around the new vertex may give it a fourth neighbour: only then it can go.
    Ring ring;
    REQUIRE(closed_ring(two.patch, v, ring));
    if (ring.size == 3) CHECK_FALSE(collapse(two.patch, v, ring.vertices[0], 10, 0));
    CHECK(broken_invariant(two.patch) == "");
  }

  TEST_CASE("a split puts the metric midpoint into an edge when that brings lengths nearer to 1") {
    TwoTriangles two({{{0, -1}, {1, 0}, {-1, 0}, {0, 1}}}, kUnit);
    CHECK(split(two.patch, 1, 2, 2, 0));
    CHECK(broken_invariant(two.patch) == "");
    CHECK(two.patch.statistics.splits == 1);
    CHECK(norm(two.patch.point(4) - Point{0, 0}) < 1e-12);
    CHECK(live_triangles(two.mesh) == 4);
    TwoTriangles fine({{{0, -1}, {1, 0}, {-1, 0}, {0, 1}}},
                      [](Point) { return metric_from_size(1.6); });
    CHECK_FALSE(split(fine.patch, 1, 2, 1.25, 0));  // halves of 0.625 are further off
    CHECK(force_split(fine.patch, 0, 0));
    CHECK(broken_invariant(fine.patch) == "");
  }

  TEST_CASE("segments are never split") {
    TwoTriangles two({{{0, -1}, {1, 0}, {-1, 0}, {0, 1}}}, kUnit);
    CHECK_FALSE(split(two.patch, 0, 1, 3, 0));
    CHECK_FALSE(force_split(two.patch, 0, 1));
    CHECK_FALSE(force_split(two.patch, 0, 2));
    CHECK(two.mesh.vertices.size() == 4);
  }

  TEST_CASE("splits keep random meshes valid") {
    for (unsigned seed = 0; seed < 5; ++seed) {
      Filled filled(seed);
      std::mt19937_64 random(seed);
      for (int i = 0; i < 200; ++i) {
        const auto t = static_cast<Index>(random() % filled.patch.mesh.triangles.size());
        force_split(filled.patch, t, i % 3);
        REQUIRE(broken_invariant(filled.patch) == "");
      }
      CHECK(filled.patch.statistics.splits > 100);
      CHECK(area_of(filled.patch.mesh) == doctest::Approx(1).epsilon(1e-12));
    }
  }

  TEST_CASE("required points become fixed vertices in triangles and on edges and on vertices") {
    Filled filled(3);
    Patch& patch = filled.patch;
    const WorkTriangle t = patch.mesh.triangles[40];
    const Point corner = patch.point(t.vertices[0]);
    const Point inside =
        (1. / 3) * (corner + patch.point(t.vertices[1]) + patch.point(t.vertices[2]));
    const Index before = live_triangles(patch.mesh);
    const std::vector<Index> v = insert_required_points(patch, {corner, inside, {0.5, 0.5}});
    REQUIRE(v.size() == 3);
    CHECK(v[0] == t.vertices[0]);
    CHECK(patch.point(v[1]) == inside);
    CHECK(patch.point(v[2]) == Point{0.5, 0.5});
    for (const Index w : v) CHECK(patch.fixed[w] == 1);
    CHECK(live_triangles(patch.mesh) == before + 4);
    CHECK(broken_invariant(patch) == "");
  }

  TEST_CASE("a required point exactly on an inner edge splits it") {
    TwoTriangles two({{{0, -1}, {1, 0}, {-1, 0}, {0, 1}}}, kUnit);
    const std::vector<Index> v = insert_required_points(two.patch, {{0.25, 0}});
    CHECK(two.patch.point(v[0]) == Point{0.25, 0});
    CHECK(live_triangles(two.mesh) == 4);
    CHECK(broken_invariant(two.patch) == "");
  }

  TEST_CASE("many required points close to each other are all inserted") {
    Filled filled(4);
    std::vector<Point> points;
    for (int i = 0; i < 200; ++i) points.push_back({0.4 + 1e-4 * i, 0.4 + 0.9e-4 * i});
    const std::vector<Index> v = insert_required_points(filled.patch, points);
    for (std::size_t i = 0; i < v.size(); ++i) CHECK(filled.patch.point(v[i]) == points[i]);
    CHECK(broken_invariant(filled.patch) == "");
  }

  TEST_CASE("required points outside or on a segment are refused with the place") {
    Filled filled(5);
    const auto message = [&](Point p) {
      try {
        insert_required_points(filled.patch, {p});
      } catch (const MeshingError& error) {
        return std::string(error.what());
      }
      return std::string();
    };
    CHECK(message({3, 0.5}).find("(3.0") != std::string::npos);
    CHECK(message({3, 0.5}).find("outside") != std::string::npos);
    const Segment& s = filled.patch.mesh.segments[0];
    const Point middle = lerp(filled.patch.point(s.a), filled.patch.point(s.b), 0.5);
    CHECK(message(middle).find("boundary edge") != std::string::npos);
  }

  TEST_CASE("required points beyond the box of the background are found") {
    Domain domain;
    add_region(domain, "disc", 1, {add_curve(domain, "c", 1, make_circle({0, 0}, 1))}, {});
    const double s = std::sqrt(0.5);
    WorkCase work(domain, [](Point) { return metric_from_size(0.1); }, {-s, -s}, {s, s});
    work.advance();
    Patch patch = make_patch(*work.background, work.mesh(), {});
    const std::vector<Point> points{{0.95, 0.01}, {-0.03, -0.93}, {0.9, 0.02}};
    const std::vector<Index> v = insert_required_points(patch, points);
    for (std::size_t i = 0; i < v.size(); ++i) CHECK(patch.point(v[i]) == points[i]);
    CHECK(broken_invariant(patch) == "");
  }
}
