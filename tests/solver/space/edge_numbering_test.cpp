#include "solver/space/edge_numbering.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

std::array<Index, 2> sorted(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a triangle and a quadrilateral with one common edge have six edges") {
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0.5}};
    mesh.triangles = {{1, 4, 2}};
    mesh.quads = {{0, 1, 2, 3}};
    const EdgeNumbering numbering = number_edges(mesh);
    CHECK(numbering.count() == 6);
    CHECK(numbering.triangle_edges[0][2] == numbering.quad_edges[0][1]);  // 2 -> 1 and 1 -> 2
  }

  TEST_CASE("edge k of an element joins its corners k and k + 1") {
    const Mesh mesh = mixed_square(5, 4);
    const EdgeNumbering numbering = number_edges(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        CHECK(numbering.vertices[numbering.triangle_edges[t][k]] ==
              sorted(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]));
    for (std::size_t q = 0; q < mesh.quads.size(); ++q)
      for (int k = 0; k < 4; ++k)
        CHECK(numbering.vertices[numbering.quad_edges[q][k]] ==
              sorted(mesh.quads[q][k], mesh.quads[q][(k + 1) % 4]));
  }

  TEST_CASE("numbers run through all edges once as Euler's formula counts them") {
    const Mesh mesh = mixed_square(6, 5);
    const EdgeNumbering numbering = number_edges(mesh);
    const std::size_t faces = mesh.triangles.size() + mesh.quads.size();
    CHECK(mesh.points.size() + faces - numbering.vertices.size() == 1);
    auto edges = numbering.vertices;
    std::sort(edges.begin(), edges.end());
    CHECK(std::adjacent_find(edges.begin(), edges.end()) == edges.end());
  }

  TEST_CASE("curve edges know their edge whatever their direction") {
    Mesh mesh = square_mesh(3);
    std::swap(mesh.edges[2].vertices[0], mesh.edges[2].vertices[1]);
    const EdgeNumbering numbering = number_edges(mesh);
    REQUIRE(numbering.curve_edges.size() == mesh.edges.size());
    for (std::size_t i = 0; i < mesh.edges.size(); ++i)
      CHECK(numbering.vertices[numbering.curve_edges[i]] ==
            sorted(mesh.edges[i].vertices[0], mesh.edges[i].vertices[1]));
  }

  TEST_CASE("a curve edge that no element has is named") {
    Mesh mesh = square_mesh(2);
    mesh.edges[0].vertices = {0, 8};  // from corner to corner
    CHECK_THROWS_WITH_AS(number_edges(mesh), doctest::Contains("vertices 1 and 9"), InputError);
  }
}
