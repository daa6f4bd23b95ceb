#include "mesher/generate_collect.hpp"

#include <algorithm>
#include <chrono>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/check.hpp"
#include "tests/support/domains.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Two unit squares side by side, "west" (tag 11) and "east" (tag 12), with the interface x = 1 as
/// curve 6 (tag 7), run through upwards.
Domain two_squares() {
  Domain domain;
  const Point p[] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  for (int k = 0; k < 6; ++k)
    add_curve(domain, "side" + std::to_string(k), 1 + k, make_line(p[k], p[(k + 1) % 6]));
  add_curve(domain, "interface", 7, make_line(p[1], p[4]));
  add_region(domain, "west", 11, {0, 6, 4, 5}, {});
  add_region(domain, "east", 12, {1, 2, 3, 6}, {});
  return domain;
}

/// West one quadrilateral, east two triangles. Vertices 0 and 7 are not used.
MixedMesh work_on_two_squares() {
  MixedMesh work;
  const Point p[] = {{9, 9}, {0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}, {9, 9}};
  for (const Point q : p) work.vertices.push_back({q, factor_of(metric_from_size(1 + q.x)), 0});
  const auto side = [&](Index a, Index b, Index curve, Index left, Index right) {
    work.segments.push_back({a, b, curve, 0, 1, left, right});
  };
  side(1, 2, 0, 0, kNoIndex);
  side(2, 3, 1, 1, kNoIndex);
  side(3, 4, 2, 1, kNoIndex);
  side(4, 5, 3, 1, kNoIndex);
  side(5, 6, 4, 0, kNoIndex);
  side(6, 1, 5, 0, kNoIndex);
  side(2, 5, 6, 0, 1);
  work.faces = {{{2, 3, 4, kNoIndex}}, {{1, 2, 5, 6}}, {{2, 4, 5, kNoIndex}}};
  return work;
}

/// n x n squares on the unit square of square_domain(1).
MixedMesh grid(Index n) {
  MixedMesh work;
  const auto at = [n](Index i, Index j) { return j * (n + 1) + i; };
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i)
      work.vertices.push_back({{1. * i / n, 1. * j / n}, factor_of(metric_from_size(1. / n)), 0});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      work.faces.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}});
  const auto side = [&](Index a, Index b, Index curve, Index k) {
    work.segments.push_back({a, b, curve, 1. * k / n, 1. * (k + 1) / n, 0, kNoIndex});
  };
  for (Index k = 0; k < n; ++k) {
    side(at(k, 0), at(k + 1, 0), 0, k);
    side(at(n, k), at(n, k + 1), 1, k);
    side(at(n - k, n), at(n - k - 1, n), 2, k);
    side(at(0, n - k), at(0, n - k - 1), 3, k);
  }
  return work;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("triangles and quadrilaterals come apart with the regions of their side") {
    const Collected made = collect(two_squares(), work_on_two_squares(), {});
    CHECK(check_mesh(made.mesh).defects == std::vector<std::string>{});
    CHECK(made.mesh.points == std::vector<Point>{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}});
    CHECK(made.mesh.triangles == std::vector<Triangle>{{1, 2, 3}, {1, 3, 4}});
    CHECK(made.mesh.quads == std::vector<Quad>{{0, 1, 4, 5}});
    CHECK(made.mesh.triangle_regions == std::vector<Index>{12, 12});
    CHECK(made.mesh.quad_regions == std::vector<Index>{11});
    CHECK(group_name(made.mesh, 2, 11) == "west");
    CHECK(group_name(made.mesh, 1, 7) == "interface");
    CHECK(made.mesh.corners == std::vector<Index>{0, 1, 2, 3, 4, 5});
    REQUIRE(made.metric.size() == 6);
    CHECK(made.metric[3].m11 == doctest::Approx(1 / 9.));  // size 3 at x = 2
  }

  TEST_CASE("a segment against the direction of its boundary is turned round") {
    MixedMesh work = work_on_two_squares();
    Segment& bottom = work.segments[0];
    std::swap(bottom.a, bottom.b);
    std::swap(bottom.parameter_a, bottom.parameter_b);
    std::swap(bottom.left_region, bottom.right_region);
    const CurveEdge edge = collect(two_squares(), work, {}).mesh.edges[0];
    CHECK(edge.vertices == std::array<Index, 2>{0, 1});
    CHECK(edge.parameters == std::array<double, 2>{0, 1});
  }

  TEST_CASE("points of the domain keep their vertex and tag") {
    Domain domain = two_squares();
    domain.points = {{"here", 30, {1, 1}}, {"there", 0, {2, 0}}};
    const Mesh mesh = collect(domain, work_on_two_squares(), {5, 3}).mesh;
    CHECK(mesh.required_vertices == std::vector<Index>{4, 2});
    CHECK(mesh.vertex_tags[4] == 30);
    CHECK_THROWS_WITH_AS(collect(domain, work_on_two_squares(), {kNoIndex, 3}),
                         doctest::Contains("\"here\" at (1, 1) is no vertex"), MeshingError);
    CHECK_THROWS_AS(collect(domain, work_on_two_squares(), {5, 7}), MeshingError);
  }

  TEST_CASE("regions spread over quadrilaterals and stop at embedded curves of one region") {
    Domain domain = square_domain(1);
    domain.regions[0].embedded_curves = {
        add_curve(domain, "crack", 9, make_line({0.5, 0}, {0.5, 1}))};
    MixedMesh work = grid(4);
    for (Index j = 0; j < 4; ++j)
      work.segments.push_back({5 * j + 2, 5 * j + 7, 4, 0.25 * j, 0.25 * (j + 1), 0, 0});
    const Mesh mesh = collect(domain, work, {}).mesh;
    CHECK(check_mesh(mesh).defects == std::vector<std::string>{});
    CHECK(mesh.quad_regions == std::vector<Index>(16, 5));
    CHECK(mesh.edges.size() == 20);
  }

  TEST_CASE("a face that no segment gives a region is refused with the place") {
    MixedMesh work = grid(2);
    for (Index v = 0; v < 4; ++v) work.vertices.push_back(work.vertices[v]);
    work.vertices[9].p = {3, 3};
    work.vertices[10].p = {4, 3};
    work.vertices[11].p = {4, 4};
    work.vertices[12].p = {3, 4};
    work.faces.push_back({{9, 10, 11, 12}});
    CHECK_THROWS_WITH_AS(collect(square_domain(1), work, {}), doctest::Contains("(3, 3)"),
                         MeshingError);
  }

  TEST_CASE("a triangle among quadrilaterals is refused with its place") {
    CHECK_NOTHROW(require_quadrilaterals(grid(2)));
    CHECK_THROWS_WITH_AS(require_quadrilaterals(work_on_two_squares()),
                         doctest::Contains("2 triangles could not be turned into quadrilaterals, "
                                           "the first at (1, 0)"),
                         MeshingError);
  }

  TEST_CASE("a lost segment is left to the check of the mesh") {
    MixedMesh work = grid(2);
    work.segments.erase(work.segments.begin());
    const Mesh mesh = collect(square_domain(1), work, {}).mesh;
    CHECK(mesh.quad_regions == std::vector<Index>(4, 5));
    CHECK_THROWS_WITH_AS(require_valid(mesh), doctest::Contains("is on no curve"), MeshingError);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("a million quadrilaterals are collected in about a second") {
    const Domain domain = square_domain(1);
    MixedMesh work = grid(1000);
    const auto start = std::chrono::steady_clock::now();
    const Mesh mesh = collect(domain, std::move(work), {}).mesh;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    MESSAGE("seconds: " << seconds.count());
    CHECK(mesh.quads.size() == 1'000'000);
    CHECK(seconds.count() < 5);
  }
}
