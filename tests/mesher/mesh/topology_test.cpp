#include "mesher/mesh/topology.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"

using namespace anisofront;

namespace {

/// 2--3      two triangles and, to their right, one quad:
/// |\ |\     vertices 0 (0,0) 1 (1,0) 2 (0,1) 3 (1,1) 4 (2,0) 5 (2,1)
/// 0--1--4
Mesh small_mixed_mesh() {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {2, 1}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  mesh.quads = {{1, 4, 5, 3}};
  mesh.triangle_regions = {1, 1};
  mesh.quad_regions = {1};
  return mesh;
}

/// A disc-like fan or a random subset of a triangulated square, elements and corners shuffled.
std::vector<Triangle> shuffled_square(int n, std::mt19937_64& random) {
  std::vector<Triangle> triangles;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i, b = a + 1, c = a + n + 2, d = a + n + 1;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  std::shuffle(triangles.begin(), triangles.end(), random);
  triangles.resize(triangles.size() * 3 / 4);
  for (Triangle& t : triangles) std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  return triangles;
}

/// The definition, by looking every directed edge up in an ordered map.
TriangleNeighbours neighbours_by_map(const std::vector<Triangle>& triangles) {
  std::map<std::array<Index, 2>, Index> owner;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      owner[{triangles[t][(k + 1) % 3], triangles[t][(k + 2) % 3]}] = static_cast<Index>(t);
  TriangleNeighbours result(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = owner.find({triangles[t][(k + 2) % 3], triangles[t][(k + 1) % 3]});
      result[t][k] = found == owner.end() ? kNoIndex : found->second;
    }
  return result;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("neighbour k lies across the edge opposite vertex k") {
    const std::vector<Triangle> triangles{{0, 1, 2}, {1, 3, 2}};
    const TriangleNeighbours n = triangle_neighbours(triangles, 4);
    CHECK(n[0] == std::array<Index, 3>{1, kNoIndex, kNoIndex});
    CHECK(n[1] == std::array<Index, 3>{kNoIndex, 0, kNoIndex});
  }

  TEST_CASE("no triangles have no neighbours") {
    CHECK(triangle_neighbours({}, 0).empty());
    CHECK(triangle_neighbours({}, 5).empty());
    CHECK(mesh_edges(Mesh{}).empty());
    CHECK(boundary_edges(Mesh{}).empty());
    CHECK(vertex_stars(Mesh{}).first == std::vector<Index>{0});
  }

  TEST_CASE("an edge of three triangles is an error that names its vertices") {
    const std::vector<Triangle> book{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    CHECK_THROWS_WITH_AS(triangle_neighbours(book, 5),
                         doctest::Contains("the edge between vertices 1 and 2 is shared by more "
                                           "than two triangles"),
                         InputError);
  }

  TEST_CASE("an edge run through twice in one direction is an error that names its vertices") {
    const std::vector<Triangle> flipped{{4, 7, 2}, {4, 7, 3}};
    CHECK_THROWS_WITH_AS(triangle_neighbours(flipped, 8),
                         doctest::Contains("the edge between vertices 5 and 8 is run through in "
                                           "the same direction by triangles 1 and 2"),
                         InputError);
  }

  TEST_CASE("a vertex number outside the mesh is an error") {
    const std::vector<Triangle> triangles{{0, 1, 2}, {1, 3, 2}};
    CHECK_THROWS_WITH_AS(triangle_neighbours(triangles, 3),
                         doctest::Contains("triangle 2 refers to vertex 4, expected 1 to 3"),
                         InputError);
    const std::vector<Triangle> negative{{0, -1, 2}};
    CHECK_THROWS_AS(triangle_neighbours(negative, 3), InputError);
  }

  TEST_CASE("half-edges of triangles and quads follow their documented order") {
    const Mesh mesh = small_mixed_mesh();
    const HalfEdges edges = half_edges(mesh);
    REQUIRE(edges.count() == 10);
    CHECK(edges[0].from == 1);  // opposite vertex 0 of triangle 0 1 2
    CHECK(edges[0].to == 2);
    CHECK(edges[5].from == 1);  // opposite vertex 2 (the third) of triangle 1 3 2
    CHECK(edges[5].to == 3);
    CHECK(edges[9].from == 3);  // last side of quad 1 4 5 3
    CHECK(edges[9].to == 1);
    CHECK(edges.element(5) == 1);
    CHECK(edges.element(9) == 2);
    const HalfEdgeTwins twins = half_edge_twins(edges, 6);
    CHECK(twins.conflicts.empty());
    CHECK(twins.twin[5] == 9);
    CHECK(twins.twin[9] == 5);
    CHECK(std::count(twins.twin.begin(), twins.twin.end(), kNoIndex) == 6);
  }

  TEST_CASE("edges of a mixed mesh come once and in element order") {
    const std::vector<std::array<Index, 2>> expected{{1, 2}, {0, 2}, {0, 1}, {2, 3},
                                                     {1, 3}, {1, 4}, {4, 5}, {3, 5}};
    CHECK(mesh_edges(small_mixed_mesh()) == expected);
  }

  TEST_CASE("boundary edges keep their element on the left") {
    const std::vector<std::array<Index, 2>> expected{{2, 0}, {0, 1}, {3, 2},
                                                     {1, 4}, {4, 5}, {5, 3}};
    CHECK(boundary_edges(small_mixed_mesh()) == expected);
  }

  TEST_CASE("vertex stars list the incident elements") {
    const VertexStars stars = vertex_stars(small_mixed_mesh());
    CHECK(stars.first == std::vector<Index>{0, 1, 4, 6, 8, 9, 10});
    CHECK(stars.elements == std::vector<Index>{0, 0, 1, 2, 0, 1, 1, 2, 2, 2});
  }

  TEST_CASE("vertex neighbours follow edges and not the diagonals of quads") {
    const VertexNeighbours n = vertex_neighbours(small_mixed_mesh());
    REQUIRE(n.first == std::vector<Index>{0, 2, 6, 9, 12, 14, 16});
    const std::set<Index> of_1(n.vertices.begin() + 2, n.vertices.begin() + 6);
    CHECK(of_1 == std::set<Index>{0, 2, 3, 4});
    const std::set<Index> of_5(n.vertices.begin() + 14, n.vertices.begin() + 16);
    CHECK(of_5 == std::set<Index>{3, 4});
  }
}

TEST_SUITE("property") {
  TEST_CASE("neighbours agree with a search of all directed edges") {
    std::mt19937_64 random(7);
    for (int n = 1; n <= 24; ++n) {
      const std::vector<Triangle> triangles = shuffled_square(n, random);
      CHECK(triangle_neighbours(triangles, (n + 1) * (n + 1)) == neighbours_by_map(triangles));
    }
  }

  TEST_CASE("a fan of many triangles about one vertex takes linear time") {
    const Index n = 1000000;
    std::vector<Triangle> fan;
    for (Index i = 0; i < n; ++i) fan.push_back({0, 1 + i, 1 + (i + 1) % n});
    std::mt19937_64 random(3);
    std::shuffle(fan.begin(), fan.end(), random);  // quadratic would take hours
    const TriangleNeighbours neighbours = triangle_neighbours(fan, n + 1);
    Index boundary = 0;
    for (const auto& of_triangle : neighbours)
      boundary += static_cast<Index>(std::count(of_triangle.begin(), of_triangle.end(), kNoIndex));
    CHECK(boundary == n);
  }
}
