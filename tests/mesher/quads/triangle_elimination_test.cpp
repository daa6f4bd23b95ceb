#include "mesher/quads/triangle_elimination.hpp"

#include <doctest/doctest.h>

#include "mesher/quads/mixed_quality.hpp"
#include "mesher/quads/mixed_topology.hpp"
#include "tests/support/mixed_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

const BackgroundMesh& unit_metric() {
  static const auto metric =
      background([](Point) { return metric_from_size(1); }, {-16, -16}, {16, 16});
  return *metric;
}

Index eliminate(MixedMesh& mesh) {
  look_up_metrics(unit_metric(), mesh);
  return eliminate_triangles(unit_metric(), mesh);
}

void add_outline(MixedMesh& mesh, const std::vector<Index>& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    mesh.segments.push_back({loop[i], loop[(i + 1) % loop.size()], 0, 0, 1, 0, kNoIndex});
}

/// Two thin triangles 8-5-9 and 8-9-6 between four quadrilaterals in the square [-2, 2]^2: their
/// common edge 8-9 joins the points (0, -1/4) and (0, 1/4).
MixedMesh two_at_an_edge() {
  MixedMesh mesh = mixed_mesh(
      {{-2, -2}, {0, -2}, {2, -2}, {2, 2}, {0, 2}, {2, 0}, {-2, 0}, {-2, 2}, {0, -0.25}, {0, 0.25}},
      {triangle(8, 5, 9), triangle(8, 9, 6), quad(0, 1, 8, 6), quad(1, 2, 5, 8), quad(5, 3, 4, 9),
       quad(9, 4, 7, 6)});
  add_outline(mesh, {0, 1, 2, 5, 3, 4, 7, 6});
  return mesh;
}

/// A quadrilateral B P1 X P2 = 8 10 1 9 with a triangle at each of the edges that meet in B; X lies
/// on the boundary of [-2, 2]^2.
MixedMesh two_at_a_quad() {
  MixedMesh mesh =
      mixed_mesh({{-2, -2},
                  {0, -2},
                  {2, -2},
                  {2, 0},
                  {2, 2},
                  {0, 2},
                  {-2, 2},
                  {-2, 0},
                  {0, 1},
                  {0.5, -0.25},
                  {-0.5, -0.25}},
                 {quad(8, 10, 1, 9), triangle(8, 9, 3), triangle(8, 7, 10), quad(1, 2, 3, 9),
                  quad(0, 1, 10, 7), quad(8, 3, 4, 5), quad(8, 5, 6, 7)});
  add_outline(mesh, {0, 1, 2, 3, 4, 5, 6, 7});
  return mesh;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the edge of two triangles collapses to its midpoint") {
    MixedMesh mesh = two_at_an_edge();
    REQUIRE(first_defect(mesh) == "");
    CHECK(eliminate(mesh) == 2);
    CHECK(triangle_count(mesh) == 0);
    CHECK(mesh.faces.size() == 4);
    CHECK(mesh.vertices[8].p == Point{0, 0});
    CHECK(first_defect(mesh) == "");
    CHECK(check_mesh(to_mesh(mesh)).area == 16);
  }

  TEST_CASE("an end of the edge that is fixed stays and two fixed ends prevent it") {
    for (const Index v : {8, 9}) {
      MixedMesh mesh = two_at_an_edge();
      mesh.required[v] = 1;
      const Point place = mesh.vertices[v].p;
      CHECK(eliminate(mesh) == 2);
      CHECK(mesh.vertices[v].p == place);
      CHECK(face_stars(mesh)[v].size() == 4);
      CHECK(face_stars(mesh)[17 - v].empty());
      CHECK(first_defect(mesh) == "");
    }
    MixedMesh both = two_at_an_edge();
    both.required[8] = both.required[9] = 1;
    CHECK(eliminate(both) == 0);
    CHECK(both.faces.size() == 6);
  }

  TEST_CASE("an edge on a segment is kept") {
    MixedMesh mesh = two_at_an_edge();
    mesh.segments.push_back({8, 9, 1, 0, 1, 0, 0});
    CHECK(eliminate(mesh) == 0);
  }

  TEST_CASE("a quadrilateral between two triangles collapses along its diagonal") {
    MixedMesh mesh = two_at_a_quad();
    REQUIRE(first_defect(mesh) == "");
    CHECK(eliminate(mesh) == 2);
    CHECK(triangle_count(mesh) == 0);
    CHECK(mesh.faces.size() == 5);
    CHECK(mesh.vertices[9].p == Point{0, -0.25});
    CHECK(first_defect(mesh) == "");
    CHECK(check_mesh(to_mesh(mesh)).area == 16);
  }

  TEST_CASE("a segment between the quadrilateral and a triangle is kept") {
    MixedMesh mesh = two_at_a_quad();
    mesh.segments.push_back({8, 9, 1, 0, 1, 0, 0});
    CHECK(eliminate(mesh) == 0);
    CHECK(mesh.faces.size() == 7);
  }

  TEST_CASE("nothing is done where a face would not be convex") {
    MixedMesh mesh = two_at_an_edge();
    mesh.vertices[5].p = {1, 0};
    mesh.vertices[6].p = {-1, 0};
    mesh.vertices[4].p = {0, 12};
    mesh.vertices[9].p = {0, 10};
    REQUIRE(first_defect(mesh) == "");
    // Q = (0, 4.875) would make the quadrilateral (0, -2) (2, -2) (1, 0) Q concave at (1, 0).
    CHECK(eliminate(mesh) == 0);
    CHECK(mesh.faces.size() == 6);
    CHECK(mesh.vertices[8].p == Point{0, -0.25});
  }

  TEST_CASE("nothing is done where a good face would become a bad one") {
    MixedMesh mesh = two_at_an_edge();
    mesh.vertices[5].p = {1, 0};
    mesh.vertices[6].p = {-1, 0};
    mesh.vertices[4].p = {0, 6};
    mesh.vertices[9].p = {0, 4.05};
    REQUIRE(first_defect(mesh) == "");
    CHECK(eliminate(mesh) == 0);     // Q = (0, 1.9): (2, -2) (1, 0) Q would be almost straight
    mesh.vertices[9].p = {0, 2.25};  // Q = (0, 1)
    CHECK(eliminate(mesh) == 2);
  }

  TEST_CASE("a mesh without triangles is left alone") {
    MixedMesh mesh = square_grid(3);
    CHECK(eliminate(mesh) == 0);
    CHECK(mesh.faces.size() == 9);
  }
}

TEST_SUITE("property") {
  TEST_CASE("elimination keeps meshes valid and fixed vertices in place") {
    Index removed = 0;
    for (int seed = 0; seed < 40; ++seed) {
      std::mt19937_64 random(seed);
      MixedMesh mesh = random_grid(random, 8, 0.24, 0.5);
      const auto metric = background(smooth_random_metric(random, 0.1, 5, 1.5), {0, 0}, {1, 1});
      look_up_metrics(*metric, mesh);
      mesh.required[40] = 1;
      const MixedMesh before = mesh;
      const Index triangles = triangle_count(mesh);
      const Index gone = eliminate_triangles(*metric, mesh);
      removed += gone;
      CHECK(triangle_count(mesh) == triangles - gone);
      CHECK(first_defect(mesh) == "");
      CHECK(check_mesh(to_mesh(mesh)).area == doctest::Approx(1).epsilon(1e-12));
      const std::vector<char> fixed = fixed_vertices(before);
      for (std::size_t v = 0; v < fixed.size(); ++v)
        if (fixed[v]) CHECK(mesh.vertices[v].p == before.vertices[v].p);
      for (const MixedFace& f : mesh.faces) CHECK(shape_quality(mesh, f) > 0);
    }
    CHECK(removed > 100);
  }
}
