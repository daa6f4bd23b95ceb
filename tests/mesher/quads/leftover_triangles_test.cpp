#include "mesher/quads/leftover_triangles.hpp"

#include <random>

#include <doctest/doctest.h>

#include "mesher/quads/pairing_candidates.hpp"
#include "mesher/quads/recut.hpp"
#include "tests/mesher/quads/pairing_support.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Nothing is paired: the worst a pairing can leave.
MixedMesh unpaired(const WorkMesh& mesh) {
  MixedMesh mixed{mesh.vertices, mesh.segments, {}, std::vector<char>(mesh.vertices.size(), 0)};
  for (const WorkTriangle& t : mesh.triangles)
    if (!t.dead()) mixed.faces.push_back({{t.vertices[0], t.vertices[1], t.vertices[2], kNoIndex}});
  return mixed;
}

/// A random set of pairs, convex or not, never across segments.
MixedMesh randomly_paired(const WorkMesh& mesh, double share, std::mt19937_64& random) {
  MixedMesh mixed{mesh.vertices, mesh.segments, {}, std::vector<char>(mesh.vertices.size(), 0)};
  std::vector<char> done(mesh.triangles.size(), 0);
  std::uniform_real_distribution<double> unit(0, 1);
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    if (done[t] || mesh.triangles[t].dead()) continue;
    for (int k = 0; k < 3 && !done[t]; ++k) {
      const Index other = mesh.triangles[t].neighbours[k];
      if (other < t || done[other] || unit(random) > share) continue;
      mixed.faces.push_back({merged_quad(mesh, t, k)});
      done[t] = done[other] = 1;
    }
    const auto [a, b, c] = mesh.triangles[t].vertices;
    if (!done[t]) mixed.faces.push_back({{a, b, c, kNoIndex}});
    done[t] = 1;
  }
  return mixed;
}

/// Walks the triangles and checks all laws; the triangles that must remain are one per odd part.
void check_walked(const WorkMesh& before, MixedMesh mixed) {
  REQUIRE(broken_law(before, mixed) == "");
  std::vector<Index> expected = triangles_per_part(mixed);
  for (Index& count : expected) count %= 2;
  std::sort(expected.begin(), expected.end());
  const Index left = merge_leftover_triangles(mixed);
  CHECK(broken_law(before, mixed) == "");
  std::vector<Index> counts = triangles_per_part(mixed);
  std::sort(counts.begin(), counts.end());
  CHECK(counts == expected);
  CHECK(left == triangles_in(mixed));
}

/// A row of n unit squares between two triangles, the left and the right one.
struct Row {
  WorkMesh triangles;
  MixedMesh mixed;
};
Row row_of_squares(Index n) {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  MixedMesh mixed;
  for (Index i = 0; i <= n; ++i) {
    points.push_back({static_cast<double>(i), 0});
    points.push_back({static_cast<double>(i), 1});
  }
  const auto left = static_cast<Index>(points.size());
  points.push_back({-1, 0.5});
  points.push_back({n + 1., 0.5});
  triangles.push_back({left, 0, 1});
  mixed.faces.push_back({{left, 0, 1, kNoIndex}});
  for (Index a = 0; a < 2 * n; a += 2) {
    triangles.push_back({a, a + 2, a + 3});
    triangles.push_back({a, a + 3, a + 1});
    mixed.faces.push_back({{a, a + 2, a + 3, a + 1}});
  }
  triangles.push_back({2 * n, left + 1, 2 * n + 1});
  mixed.faces.push_back({{2 * n, left + 1, 2 * n + 1, kNoIndex}});
  Row row{work_mesh(points, triangles), mixed};
  row.mixed.vertices = row.triangles.vertices;
  row.mixed.segments = row.triangles.segments;
  row.mixed.required.assign(points.size(), 0);
  return row;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("two triangles side by side merge") {
    check_walked(right_triangles(1, 1), unpaired(right_triangles(1, 1)));
  }

  TEST_CASE("two triangles walk through the quadrilaterals between them") {
    for (const Index n : {1, 2, 3, 8, 50}) {
      Row row = row_of_squares(n);
      CHECK(merge_leftover_triangles(row.mixed) == 0);
      CHECK(static_cast<Index>(row.mixed.faces.size()) == n + 1);
      CHECK(broken_law(row.triangles, row.mixed) == "");
    }
  }

  TEST_CASE("the cheaper cut of a pentagon is taken") {
    Row row = row_of_squares(1);
    const FaceLinks links = link_faces(row.mixed);
    // Both cuts serve the right side: triangle 0 2 3 or 2 3 1. With a corner pulled down or up the
    // other one would leave a reflex corner at 0 or 1.
    const auto triangle_when = [&](Index corner, Point place) {
      std::vector<WorkVertex> vertices = row.mixed.vertices;
      vertices[corner].p = place;
      const Recut recut = best_recut(links, vertices, 0, 1, 2);
      REQUIRE(recut.possible());
      return std::set<Index>{links.from(recut.outer[0]), links.from(recut.outer[1]),
                             links.from(recut.outer[2])};
    };
    CHECK(triangle_when(2, {1, -0.8}) == std::set<Index>{0, 2, 3});
    CHECK(triangle_when(3, {1, 1.8}) == std::set<Index>{2, 3, 1});
  }

  TEST_CASE("no edge comes to be twice") {
    // A roof 1 2 3 over the square 0 1 3 4, which is cut into triangle 0 1 4 and a quadrilateral.
    // The best cut, along the eaves 1 3, is refused where an edge 1 3 exists outside already.
    const auto cut = [](const MixedFace& beyond) {
      MixedMesh mesh;
      for (const Point p : {Point{1, 0}, {1, 1}, {0.5, 1.87}, {0, 1}, {0, 0}, {-1, 2}})
        mesh.vertices.push_back({p, {}, 0});
      mesh.faces = {{{0, 1, 4, kNoIndex}}, {{4, 1, 2, 3}}, beyond};
      const FaceLinks links = link_faces(mesh);
      const Recut recut = best_recut(links, mesh.vertices, 0, 1, 2);
      REQUIRE(recut.possible());
      std::set<Index> triangle;
      for (int i = 0; i < 3; ++i) triangle.insert(links.from(recut.outer[i]));
      return triangle;
    };
    CHECK(cut({{3, 2, 5, kNoIndex}}) == std::set<Index>{1, 2, 3});
    CHECK(cut({{3, 2, 1, kNoIndex}}) != std::set<Index>{1, 2, 3});
  }

  TEST_CASE("a triangle comes out of the corner that a quadrilateral makes round an inner vertex") {
    // Vertex 3 inside the triangle 0 1 2 has two edges only, to 0 and 1. The triangle 0 1 3 must
    // leave over each of the two other sides.
    for (const bool right : {true, false}) {
      const WorkMesh before = work_mesh(
          {{0, 0}, {4, 0}, {2, 3}, {2, 1}, right ? Point{5, 3} : Point{-1, 3}},
          {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, right ? Triangle{1, 4, 2} : Triangle{2, 4, 0}});
      MixedMesh mixed{before.vertices, before.segments, {}, {}};
      mixed.faces = {{{0, 1, 3, kNoIndex}},
                     {{1, 2, 0, 3}},
                     right ? MixedFace{{1, 4, 2, kNoIndex}} : MixedFace{{2, 4, 0, kNoIndex}}};
      CHECK(merge_leftover_triangles(mixed) == 0);
      CHECK(broken_law(before, mixed) == "");
      CHECK(mixed.faces.size() == 2);
    }
  }

  TEST_CASE("a flipped face costs more than any other and less than infinity") {
    std::vector<WorkVertex> v{
        {{0, 0}, {}, 0}, {{1, 0}, {}, 0}, {{0.1, 0.001}, {}, 0}, {{0, 1}, {}, 0}};
    const MixedFace dart{{0, 1, 2, 3}}, clockwise{{0, 3, 1, kNoIndex}};
    const MixedFace thin{{0, 1, 2, kNoIndex}}, equilateral{{0, 1, 3, kNoIndex}};
    CHECK(face_cost(v, equilateral) < face_cost(v, thin));
    CHECK(face_cost(v, thin) < face_cost(v, dart));
    CHECK(face_cost(v, thin) < face_cost(v, clockwise));
    CHECK(face_cost(v, clockwise) < 100);
    v = {{{0, 0}, {}, 0}, {{2, 0}, {}, 0}, {{2, 3}, {}, 0}, {{0, 3}, {}, 0}};
    CHECK(face_cost(v, {{0, 1, 2, 3}}) == doctest::Approx(0));
  }

  TEST_CASE("a single triangle stays where it is") {
    const WorkMesh mesh = work_mesh({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}});
    MixedMesh mixed = unpaired(mesh);
    CHECK(merge_leftover_triangles(mixed) == 1);
    CHECK(broken_law(mesh, mixed) == "");
    MixedMesh empty;
    CHECK(merge_leftover_triangles(empty) == 0);
  }

  TEST_CASE("triangles on the two sides of a segment never merge") {
    const WorkMesh mesh = right_triangles(1, 1, {{0, 3}});
    MixedMesh mixed = unpaired(mesh);
    CHECK(merge_leftover_triangles(mixed) == 2);
    CHECK(broken_law(mesh, mixed) == "");
  }

  TEST_CASE("every region keeps its own odd triangle") {
    // Two regions with 3 x 3 squares and a half each beside their interface, a staircase.
    std::vector<VertexPair> walls;
    for (Index j = 0; j < 3; ++j) walls.push_back({7 * j + 3, 7 * (j + 1) + 3});
    walls[1] = {7 + 3, 7 * 2 + 4};  // along a diagonal: one triangle changes sides
    walls.push_back({7 * 2 + 3, 7 * 2 + 4});
    walls[2] = {7 * 2 + 3, 7 * 3 + 3};
    const WorkMesh mesh = right_triangles(6, 3, walls);
    CHECK(triangles_per_part(unpaired(mesh)) == std::vector<Index>{19, 17});
    check_walked(mesh, unpaired(mesh));
  }

  TEST_CASE("fans of three unmergeable triangles are recut") {
    // Three concave pairs around a point: merged all the same, smoothing repairs them.
    const WorkMesh mesh = work_mesh({{0, 0}, {3, 0}, {0, 3}, {1, 1}, {3, 3}},
                                    {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 4, 2}});
    check_walked(mesh, unpaired(mesh));
  }

  TEST_CASE("a walk goes round the end of an embedded segment") {
    // A slit along the middle row of edges, open at the right: the triangles lie left above and
    // below it.
    std::vector<VertexPair> walls;
    for (Index i = 0; i < 5; ++i) walls.push_back({7 + i, 8 + i});
    const WorkMesh mesh = right_triangles(6, 2, walls);
    MixedMesh mixed = pair_triangles(mesh, {}, Pairing::matching);
    REQUIRE(triangles_in(mixed) == 0);
    // Row by row shifted by one triangle: halves remain at both ends.
    mixed.faces.clear();
    for (Index j = 0; j < 2; ++j) {
      const Index a = 7 * j, d = a + 7;
      mixed.faces.push_back({{a, d + 1, d, kNoIndex}});
      for (Index i = 0; i < 5; ++i)
        mixed.faces.push_back({{a + i, a + i + 1, d + i + 2, d + i + 1}});
      mixed.faces.push_back({{a + 5, a + 6, d + 6, kNoIndex}});
    }
    check_walked(mesh, mixed);
  }
}

TEST_SUITE("property") {
  TEST_CASE("whatever was paired each part ends with no triangle or one") {
    std::mt19937_64 random(17);
    for (int i = 0; i < 60; ++i) {
      const auto pick = [&](Index low, Index high) {
        return std::uniform_int_distribution<Index>(low, high)(random);
      };
      const Index n = pick(1, 9), m = pick(1, 9);
      std::vector<VertexPair> walls;
      for (Index w = pick(0, 12); w > 0; --w) {
        const Index a = pick(0, m) * (n + 1) + pick(0, n - 1);
        walls.push_back({a, a + 1});
      }
      const WorkMesh mesh = right_triangles(n, m, walls);
      check_walked(mesh, randomly_paired(mesh, 0.1 * (i % 10), random));
    }
  }

  TEST_CASE("polygons with holes become quadrilaterals after every pairing") {
    std::mt19937_64 random(29);
    for (int i = 0; i < 8; ++i) {
      const KnownDomain known = star_domain(random);
      WorkCase work(known.domain, smooth_random_metric(random, 0.08, 20, 1.5), {-1.1, -1.1},
                    {1.1, 1.1}, 12);
      triangulate(work, i % 2 == 0 ? Start::equilateral : Start::right_angle);
      for (const Pairing pairing : kPairings)
        check_walked(work.mesh(), pair_triangles(work.mesh(), {}, pairing));
      check_walked(work.mesh(), unpaired(work.mesh()));
      check_walked(work.mesh(), randomly_paired(work.mesh(), 0.5, random));
    }
  }
}
