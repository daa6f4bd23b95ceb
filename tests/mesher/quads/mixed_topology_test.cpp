#include "mesher/quads/mixed_topology.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/support/mixed_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// A square with a triangle on its right side and the bottom of the square on a segment.
MixedMesh house() {
  MixedMesh mesh =
      mixed_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0.5}}, {triangle(1, 4, 2), quad(0, 1, 2, 3)});
  mesh.segments.push_back({1, 0, 0, 0, 1, kNoIndex, 0});
  return mesh;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("every edge of a mixed mesh comes once with its faces and its segment") {
    const MixedEdges topology = mixed_edges(house());
    REQUIRE(topology.edges.size() == 6);
    const MixedEdge& common = topology.edges[2];
    CHECK(common.a == 2);  // as the triangle runs through it
    CHECK(common.b == 1);
    CHECK(common.left == 0);
    CHECK(common.right == 1);
    CHECK(common.segment == kNoIndex);
    CHECK(topology.of_face[0] == std::array<Index, 4>{0, 1, 2, kNoIndex});
    CHECK(topology.of_face[1] == std::array<Index, 4>{3, 2, 4, 5});
    CHECK(topology.edges[3].segment == 0);  // whichever way the segment runs
    CHECK(topology.edges[3].right == kNoIndex);
    CHECK(topology.edges[4].segment == kNoIndex);
  }

  TEST_CASE("edges agree with the faces that hold them on random mixed meshes") {
    std::mt19937_64 random(3);
    const MixedMesh mesh = random_grid(random, 9, 0.2, 0.4);
    const MixedEdges topology = mixed_edges(mesh);
    Index sides = 0, on_segments = 0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      for (int k = 0; k < mesh.faces[f].size(); ++k, ++sides) {
        const MixedEdge& e = topology.edges[topology.of_face[f][k]];
        const Index a = mesh.faces[f].vertices[k], b = vertex_at(mesh.faces[f], k + 1);
        const bool left = e.left == static_cast<Index>(f);
        CHECK((left || e.right == static_cast<Index>(f)));
        CHECK(e.a == (left ? a : b));
        CHECK(e.b == (left ? b : a));
      }
    for (const MixedEdge& e : topology.edges) {
      on_segments += e.segment == kNoIndex ? 0 : 1;
      CHECK((e.right == kNoIndex) == (e.segment != kNoIndex));
    }
    CHECK(on_segments == 36);
    CHECK(2 * static_cast<Index>(topology.edges.size()) == sides + 36);
  }

  TEST_CASE("edges between more than two faces are refused with their vertices") {
    MixedMesh twice = house();
    twice.faces.push_back(triangle(1, 4, 2));
    CHECK_THROWS_WITH_AS(mixed_edges(twice), doctest::Contains("vertices 2 and 1"), MeshingError);
  }

  TEST_CASE("stars list the faces of a vertex with its place in them") {
    const FaceStars stars = face_stars(house());
    const std::size_t sizes[] = {1, 2, 2, 1, 1};
    for (Index v = 0; v < 5; ++v) CHECK(stars[v].size() == sizes[v]);
    CHECK(stars[2][0].face == 0);
    CHECK(stars[2][0].k == 2);
    CHECK(stars[2][1].face == 1);
    CHECK(stars[2][1].k == 2);
    MixedMesh lonely = house();
    lonely.vertices.emplace_back();
    CHECK(face_stars(lonely)[5].empty());
  }

  TEST_CASE("vertices on segments and required ones are fixed") {
    MixedMesh mesh = house();
    mesh.required[4] = 1;
    CHECK(fixed_vertices(mesh) == std::vector<char>{1, 1, 0, 0, 1});
    CHECK(triangle_count(mesh) == 1);
  }

  TEST_CASE("a mesh without faces has no edges") {
    CHECK(mixed_edges(MixedMesh()).edges.empty());
    CHECK(triangle_count(MixedMesh()) == 0);
  }
}
