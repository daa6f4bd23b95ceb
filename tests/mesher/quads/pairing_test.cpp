#include "mesher/quads/pairing.hpp"

#include <random>

#include <doctest/doctest.h>

#include "mesher/geometry/predicates.hpp"
#include "tests/mesher/quads/pairing_support.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// The unit triangles around the centre of a regular hexagon.
WorkMesh hexagon() {
  std::vector<Point> points{{0, 0}};
  std::vector<Triangle> triangles;
  for (Index k = 0; k < 6; ++k) {
    points.push_back({std::cos(k * kPi / 3), std::sin(k * kPi / 3)});
    triangles.push_back({0, 1 + k, 1 + (k + 1) % 6});
  }
  return work_mesh(points, triangles);
}

/// A triangle cut into three from a point inside: the union of any two is concave.
WorkMesh fan_of_three() {
  return work_mesh({{0, 0}, {3, 0}, {0, 3}, {0.9, 0.9}}, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

bool strictly_convex(const MixedMesh& mesh, const MixedFace& face) {
  for (int k = 0; k < 4; ++k)
    if (orientation(mesh.vertices[face.vertices[k]].p, mesh.vertices[face.vertices[(k + 1) % 4]].p,
                    mesh.vertices[face.vertices[(k + 2) % 4]].p) <= 0)
      return false;
  return true;
}

bool all_quads_convex(const MixedMesh& mesh) {
  return std::all_of(mesh.faces.begin(), mesh.faces.end(),
                     [&](const MixedFace& f) { return !f.is_quad() || strictly_convex(mesh, f); });
}

double squared_side(const MixedMesh& mesh, const MixedFace& f, int k) {
  return squared_norm(mesh.vertices[f.vertices[(k + 1) % 4]].p - mesh.vertices[f.vertices[k]].p);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("right triangles become squares again") {
    const WorkMesh mesh = right_triangles(2, 2);
    for (const Pairing pairing : kPairings) {
      const MixedMesh mixed = pair_triangles(mesh, {4}, pairing);
      CHECK(broken_law(mesh, mixed) == "");
      CHECK(mixed.faces.size() == 4);
      CHECK(triangles_in(mixed) == 0);
      for (const MixedFace& f : mixed.faces)
        for (int k = 0; k < 4; ++k) CHECK(squared_side(mixed, f, k) == 1);
      CHECK(mixed.required == std::vector<char>{0, 0, 0, 0, 1, 0, 0, 0, 0});
    }
  }

  TEST_CASE("a hexagon of six triangles becomes three rhombi") {
    const WorkMesh mesh = hexagon();
    for (const Pairing pairing : kPairings) {
      const MixedMesh mixed = pair_triangles(mesh, {}, pairing);
      CHECK(broken_law(mesh, mixed) == "");
      CHECK(mixed.faces.size() == 3);
      CHECK(triangles_in(mixed) == 0);
      for (const MixedFace& f : mixed.faces)
        for (int k = 0; k < 4; ++k) CHECK(squared_side(mixed, f, k) == doctest::Approx(1));
    }
  }

  TEST_CASE("concave pairs are never merged") {
    const WorkMesh mesh = fan_of_three();
    for (const Pairing pairing : kPairings)
      CHECK(triangles_in(pair_triangles(mesh, {}, pairing)) == 3);
  }

  TEST_CASE("a corner of 180 degrees is not convex") {
    // The midpoint of the side 0 1 is exactly on it.
    const WorkMesh mesh = work_mesh({{0, 0}, {1, 0}, {0, 1}, {0.5, 0}}, {{0, 3, 2}, {3, 1, 2}});
    for (const Pairing pairing : kPairings)
      CHECK(triangles_in(pair_triangles(mesh, {}, pairing)) == 2);
  }

  TEST_CASE("convexity is decided exactly") {
    // In decimals the first three corners lie on a line. As doubles they do or bend the wrong way,
    // while the rounded area of their triangle is positive.
    for (const auto& [a, b, c] : {std::array<Point, 3>{{{0.2, 0.2}, {0.8, 0.4}, {1.4, 0.6}}},
                                  std::array<Point, 3>{{{0.6, 0.3}, {1.1, 0.5}, {1.6, 0.7}}}}) {
      REQUIRE(twice_area(a, b, c) > 0);
      const WorkMesh mesh = work_mesh({a, b, c, {0.8, 1.5}}, {{0, 1, 3}, {1, 2, 3}});
      CHECK(triangles_in(pair_triangles(mesh, {}, Pairing::matching)) == 2);
    }
  }

  TEST_CASE("segments are never crossed") {
    // Each square has its diagonal as segment, so that good partners lie beyond segments only.
    std::vector<VertexPair> walls;
    for (Index j = 0; j < 3; ++j)
      for (Index i = 0; i < 3; ++i) walls.push_back({4 * j + i, 4 * j + i + 5});
    const WorkMesh mesh = right_triangles(3, 3, walls);
    for (const Pairing pairing : kPairings) {
      const MixedMesh mixed = pair_triangles(mesh, {}, pairing);
      CHECK(broken_law(mesh, mixed) == "");
      for (const MixedFace& f : mixed.faces)  // parallelograms, never the squares
        if (f.is_quad())
          CHECK(std::max({squared_side(mixed, f, 0), squared_side(mixed, f, 1)}) == 2);
    }
  }

  TEST_CASE("dead triangles are skipped and vertices keep their numbers") {
    WorkMesh mesh = right_triangles(2, 1);
    // The right square is taken away.
    for (const Index t : {2, 3}) mesh.triangles[t] = {};
    mesh.triangles[0].neighbours[0] = ~0;
    for (const Pairing pairing : kPairings) {
      const MixedMesh mixed = pair_triangles(mesh, {}, pairing);
      REQUIRE(mixed.faces.size() == 1);
      CHECK(mixed.vertices.size() == 6);
      const std::set<Index> corners(mixed.faces[0].vertices.begin(), mixed.faces[0].vertices.end());
      CHECK(corners == std::set<Index>{0, 1, 3, 4});
    }
  }

  TEST_CASE("a mesh without triangles stays empty") {
    for (const Pairing pairing : kPairings) CHECK(pair_triangles({}, {}, pairing).faces.empty());
  }

  TEST_CASE("the best pair comes first in order of beta and matching saves its neighbours") {
    // A square between two triangles, each of which makes a kite with its half of the square.
    const WorkMesh mesh = work_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {-1, 0.2}, {2, 0.8}},
                                    {{4, 0, 3}, {0, 1, 3}, {1, 2, 3}, {1, 5, 2}});
    CHECK(triangles_in(pair_triangles(mesh, {}, Pairing::beta_order)) == 2);
    CHECK(triangles_in(pair_triangles(mesh, {}, Pairing::matching)) == 0);
    CHECK(triangles_in(pair_triangles(mesh, {}, Pairing::systematic)) == 0);
  }

  TEST_CASE("pairs follow the metric") {
    // The middle triangle makes a square with the left one and, in the metric of a shear, with the
    // right one.
    WorkMesh mesh =
        work_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}}, {{0, 2, 3}, {0, 1, 2}, {1, 4, 2}});
    const auto quad = [&](MetricFactor r) {
      for (WorkVertex& v : mesh.vertices) v.r = r;
      const MixedMesh mixed = pair_triangles(mesh, {}, Pairing::beta_order);
      for (const MixedFace& f : mixed.faces)
        if (f.is_quad()) return std::set<Index>(f.vertices.begin(), f.vertices.end());
      return std::set<Index>{};
    };
    CHECK(quad({1, 0, 1}) == std::set<Index>{0, 1, 2, 3});
    CHECK(quad({1, -1, 1}) == std::set<Index>{0, 1, 2, 4});
  }

  TEST_CASE("merging in order ends where quadrilaterals become worse than 0.1") {
    // Unit square cut along a diagonal, one corner moved towards its middle: beta~ by hand from
    // alpha = 2 sqrt(3) (cross product / sum of squares).
    const auto left = [](double x, Pairing pairing) {
      const WorkMesh mesh = work_mesh({{0, 0}, {1, 0}, {x, x}, {0, 1}}, {{0, 1, 3}, {1, 2, 3}});
      return triangles_in(pair_triangles(mesh, {}, pairing));
    };
    // (0.04 / 3.0016) (1 / 4) / (0.52 / 2.0416)^2 = 0.051
    CHECK(left(0.52, Pairing::beta_order) == 2);
    CHECK(left(0.52, Pairing::systematic) == 2);
    CHECK(left(0.52, Pairing::matching) == 0);
    // (0.12 / 3.0144) (1 / 4) / (0.56 / 2.1344)^2 = 0.145
    CHECK(left(0.56, Pairing::beta_order) == 0);
    CHECK(left(0.56, Pairing::systematic) == 0);
  }
}

TEST_SUITE("property") {
  TEST_CASE("meshes of polygons with holes are paired without loss") {
    std::mt19937_64 random(11);
    for (int i = 0; i < 6; ++i) {
      const KnownDomain known = star_domain(random);
      WorkCase work(known.domain, smooth_random_metric(random, 0.06, 20, 1.5), {-1.1, -1.1},
                    {1.1, 1.1}, 12);
      triangulate(work, i % 2 == 0 ? Start::equilateral : Start::right_angle);
      for (const Pairing pairing : kPairings) {
        const MixedMesh mixed = pair_triangles(work.mesh(), {}, pairing);
        CHECK(broken_law(work.mesh(), mixed) == "");
        CHECK(all_quads_convex(mixed));
        const MixedMesh again = pair_triangles(work.mesh(), {}, pairing);
        CHECK(std::equal(
            mixed.faces.begin(), mixed.faces.end(), again.faces.begin(), again.faces.end(),
            [](const MixedFace& a, const MixedFace& b) { return a.vertices == b.vertices; }));
      }
    }
  }
}
