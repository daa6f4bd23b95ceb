#include "mesher/mesh/check.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"

using namespace anisofront;

namespace {

Mesh unit_square() {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangle_regions = {1, 1};
  mesh.edges = {{{0, 1}, 1}, {{1, 2}, 1}, {{2, 3}, 1}, {{3, 0}, 1}};
  return mesh;
}

/// Ring of 8 quads about the square hole [1,2]^2 of the square [0,3]^2.
Mesh square_with_hole() {
  Mesh mesh;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) mesh.points.push_back({1. * i, 1. * j});
  for (Index j = 0; j < 3; ++j)
    for (Index i = 0; i < 3; ++i)
      if (i != 1 || j != 1)
        mesh.quads.push_back({4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4});
  mesh.quad_regions.assign(8, 1);
  return mesh;
}

/// Strip of n x n squares in two triangles each, turned, stretched and moved.
Mesh turned_grid(int n, double stretch, double angle, Point shift) {
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = 1. * i / n, y = 1. * j / n / stretch;
      mesh.points.push_back({shift.x + x * std::cos(angle) - y * std::sin(angle),
                             shift.y + x * std::sin(angle) + y * std::cos(angle)});
    }
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      mesh.triangles.push_back({a, a + 1, a + n + 2});
      mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  mesh.triangle_regions.assign(mesh.triangles.size(), 1);
  return mesh;
}

std::string all_defects(const Mesh& mesh) {
  std::string text;
  for (const std::string& defect : check_mesh(mesh).defects) text += defect + "\n";
  return text;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a square of two triangles is valid and counted right") {
    const MeshReport report = check_mesh(unit_square());
    CHECK(report.valid());
    CHECK(report.vertices == 4);
    CHECK(report.triangles == 2);
    CHECK(report.quads == 0);
    CHECK(report.edges == 5);
    CHECK(report.boundary_edges == 4);
    CHECK(report.components == 1);
    CHECK(report.holes == 0);
    CHECK(report.area == 1);
    CHECK(report.boundary_area == 1);
    CHECK_NOTHROW(require_valid(unit_square()));
  }

  TEST_CASE("a ring of quads has one hole and the area without it") {
    const MeshReport report = check_mesh(square_with_hole());
    CHECK(report.valid());
    CHECK(report.edges == 24);
    CHECK(report.boundary_edges == 16);
    CHECK(report.components == 1);
    CHECK(report.holes == 1);
    CHECK(report.area == doctest::Approx(8).epsilon(1e-15));
    CHECK(report.boundary_area == doctest::Approx(8).epsilon(1e-15));
  }

  TEST_CASE("two separate squares are two components without a hole") {
    Mesh mesh = unit_square();
    for (const Point p : unit_square().points) mesh.points.push_back(p + Point{5, 0});
    mesh.triangles.push_back({4, 5, 6});
    mesh.triangles.push_back({4, 6, 7});
    mesh.triangle_regions.assign(4, 1);
    mesh.edges.clear();
    const MeshReport report = check_mesh(mesh);
    CHECK(report.valid());
    CHECK(report.components == 2);
    CHECK(report.holes == 0);
    CHECK(report.area == 2);
  }

  TEST_CASE("an empty mesh is not valid") {
    CHECK(all_defects(Mesh{}).find("no triangles and no quads") != std::string::npos);
  }

  TEST_CASE("each defect is named with its place") {
    Mesh mesh = unit_square();
    std::string expected;
    SUBCASE("clockwise triangle") {
      mesh.triangles[1] = {0, 3, 2};
      expected = "triangle 2 with vertices 1 4 3 is flat or clockwise, first vertex 1 at (0, 0)";
    }
    SUBCASE("flat triangle") {
      mesh.points[3] = {0.5, 0.5};
      expected = "triangle 2 with vertices 1 3 4 is flat or clockwise";
    }
    SUBCASE("triangle that repeats a vertex") {
      mesh.triangles[1] = {0, 2, 2};
      expected = "triangle 2 with vertices 1 3 3 is flat or clockwise";
    }
    SUBCASE("edge in one direction twice") {
      mesh.triangles[1] = {0, 3, 2};
      expected =
          "edge 3 1 from (1, 1) to (0, 0) is run through in one direction by triangle 1 and "
          "triangle 2";
    }
    SUBCASE("edge of three elements") {
      mesh.points.push_back({2, 0.5});
      mesh.triangles.push_back({0, 2, 3});
      mesh.triangles[2] = {2, 0, 4};
      mesh.triangle_regions.assign(3, 1);
      expected = "belongs to more than two elements, among them triangle 1 and triangle 3";
    }
    SUBCASE("vertex number too large") {
      mesh.triangles[1] = {0, 2, 9};
      expected = "triangle 2 refers to vertex 10, expected 1 to 4";
    }
    SUBCASE("negative vertex number") {
      mesh.edges[2].vertices = {2, -5};
      expected = "curve edge 3 refers to vertex -4, expected 1 to 4";
    }
    SUBCASE("corner that is no vertex") {
      mesh.corners = {4};
      expected = "corners, entry 1 refers to vertex 5";
    }
    SUBCASE("coordinate that is not a number") {
      mesh.points[2].y = std::numeric_limits<double>::quiet_NaN();
      expected = "vertex 3 at (1, nan) is not finite";
    }
    SUBCASE("duplicate vertex") {
      mesh.points.push_back({1, 1});
      mesh.triangles[1] = {0, 4, 3};
      expected = "vertex 5 at (1, 1) coincides with vertex 3";
    }
    SUBCASE("duplicate up to the sign of zero") {
      mesh.points.push_back({-0., 0.});
      mesh.triangles[1] = {4, 2, 3};
      expected = "vertex 5 at (-0, 0) coincides with vertex 1";
    }
    SUBCASE("unused vertex") {
      mesh.points.push_back({3, 4});
      expected = "vertex 5 at (3, 4) belongs to no element";
    }
    SUBCASE("curve edge that is no edge") {
      mesh.edges.push_back({{1, 3}, 2});
      expected = "curve edge 2 4 from (1, 0) to (0, 1) is no edge of any element";
    }
    SUBCASE("boundary edge without a curve") {
      mesh.edges.pop_back();
      expected = "boundary edge 4 1 from (0, 1) to (0, 0) is on no curve";
    }
    SUBCASE("regions missing") {
      mesh.triangle_regions = {1};
      expected = "triangle_regions has 1 entries, expected 2";
    }
    CAPTURE(expected);
    CHECK(all_defects(mesh).find(expected) != std::string::npos);
    CHECK_THROWS_WITH_AS(require_valid(mesh), doctest::Contains(expected.c_str()), MeshingError);
  }

  TEST_CASE("a quad is bad at the corner where it is not convex") {
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0}, {0.25, 0.25}, {0, 1}};
    mesh.quads = {{0, 1, 2, 3}};
    mesh.quad_regions = {1};
    const std::vector<std::string> defects = check_mesh(mesh).defects;
    REQUIRE(defects.size() == 1);
    CHECK(defects[0] ==
          "quad 1 is flat, concave or clockwise at its corner vertex 3 at (0.25, 0.25)");
  }

  TEST_CASE("an interface edge may be on a curve and a mesh without curves is valid") {
    Mesh mesh = unit_square();
    mesh.edges.push_back({{2, 0}, 7});
    CHECK(check_mesh(mesh).valid());
    mesh.edges.clear();
    CHECK(check_mesh(mesh).valid());
  }

  TEST_CASE("at most ten sentences are written per kind") {
    Mesh mesh = unit_square();
    for (int i = 0; i < 1000; ++i) mesh.points.push_back({2. + i, 3});
    CHECK(check_mesh(mesh).defects.size() == 10);
  }
}

TEST_SUITE("property") {
  TEST_CASE("areas agree on turned stretched and shifted grids") {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 40; ++i) {
      const double stretch = std::pow(10., 4 * unit(random));
      const Point shift{100 * unit(random), -1000 * unit(random)};
      const MeshReport report = check_mesh(turned_grid(12, stretch, 6 * unit(random), shift));
      CHECK(report.valid());
      CHECK(report.area == doctest::Approx(1 / stretch).epsilon(1e-8));
      CHECK(report.components - report.holes == 1);
    }
  }

  TEST_CASE("hundreds of thousands of equal vertices are reported in linear time") {
    Mesh mesh = unit_square();
    mesh.points.insert(mesh.points.end(), 300000, Point{0.5, 0.5});
    CHECK(check_mesh(mesh).defects.size() == 20);  // ten coincide, ten are unused
  }
}
