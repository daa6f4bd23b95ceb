#include "mesher/quads/face_links.hpp"

#include <doctest/doctest.h>

#include "tests/mesher/quads/pairing_support.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Squares and triangles by their vertices; those of one square are 1 apart.
MixedMesh mixed_mesh(Index vertices, const std::vector<MixedFace>& faces,
                     const std::vector<VertexPair>& walls = {}) {
  MixedMesh mesh;
  mesh.vertices.resize(static_cast<std::size_t>(vertices));
  mesh.faces = faces;
  for (const auto& [a, b] : walls) mesh.segments.push_back({a, b, 0, 0, 1, 0, 0});
  mesh.required.assign(mesh.vertices.size(), 0);
  return mesh;
}

/// The half-edge from a to b.
Index half_edge(const FaceLinks& links, Index a, Index b) {
  for (Index f = 0; f < static_cast<Index>(links.faces.size()); ++f)
    for (Index h = 4 * f; h < 4 * f + links.faces[f].size(); ++h)
      if (links.from(h) == a && links.to(h) == b) return h;
  return kNoIndex;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("half-edges meet their twins in triangles and quadrilaterals") {
    //  3 - 2
    //  |   | > 4
    //  0 - 1
    MixedMesh mesh = mixed_mesh(5, {{{0, 1, 2, 3}}, {{1, 4, 2, kNoIndex}}});
    const FaceLinks links = link_faces(mesh);
    const Index h = half_edge(links, 1, 2);
    CHECK(h == 1);
    CHECK(links.twin[h] == half_edge(links, 2, 1));
    CHECK(links.twin[links.twin[h]] == h);
    CHECK(links.across(h) == 1);
    CHECK(side_towards(links, 1, 0) == half_edge(links, 2, 1));
    CHECK(links.next(links.twin[h]) == half_edge(links, 1, 4));
    CHECK(links.previous(half_edge(links, 1, 4)) == links.twin[h]);
    for (const auto& [a, b] : {VertexPair{0, 1}, {1, 4}, {4, 2}, {2, 3}, {3, 0}}) {
      CHECK(links.twin[half_edge(links, a, b)] == kNoIndex);
      CHECK(links.across(half_edge(links, a, b)) == kNoIndex);
    }
  }

  TEST_CASE("a segment closes both sides of its edge and vertices across it are joined") {
    MixedMesh mesh = mixed_mesh(5, {{{0, 1, 2, 3}}, {{1, 4, 2, kNoIndex}}}, {{2, 1}});
    const FaceLinks links = link_faces(mesh);
    CHECK(links.across(half_edge(links, 1, 2)) == kNoIndex);
    CHECK(links.across(half_edge(links, 2, 1)) == kNoIndex);
    CHECK(side_towards(links, 0, 1) == kNoIndex);
    CHECK(is_joined(links, half_edge(links, 1, 2), 4));
  }

  TEST_CASE("all edges of a vertex are found from any of them") {
    WorkMesh triangles = right_triangles(2, 2, {{4, 5}});
    MixedMesh mesh = pair_triangles(triangles, {}, Pairing::matching);
    const FaceLinks links = link_faces(mesh);
    for (const auto& [edge, face] : directed_edges(mesh)) {
      const Index h = half_edge(links, edge.first, edge.second);
      for (Index v = 0; v < 9; ++v) {
        if (v == edge.first) continue;
        const Index a = edge.first;
        // On the grid of 3 x 3 vertices neighbours differ by one step in one direction.
        const bool joined = std::abs(a % 3 - v % 3) + std::abs(a / 3 - v / 3) == 1;
        CHECK(is_joined(links, h, v) == joined);
      }
    }
  }

  TEST_CASE("vertices where the boundary touches itself count as joined") {
    // Two squares share the corners 0 and 2 only: a ring pinched twice.
    MixedMesh mesh = mixed_mesh(6, {{{0, 1, 2, 3}}, {{2, 4, 0, 5}}});
    const FaceLinks links = link_faces(mesh);
    CHECK(is_joined(links, half_edge(links, 0, 1), 2));
    CHECK_FALSE(is_joined(links, half_edge(links, 1, 2), 3));
    CHECK_FALSE(is_joined(links, half_edge(links, 0, 1), 4));  // in the other square
  }

  TEST_CASE("renumbered half-edges keep their twins even among themselves") {
    MixedMesh mesh = mixed_mesh(5, {{{0, 1, 2, 3}}, {{1, 4, 2, kNoIndex}}});
    FaceLinks links = link_faces(mesh);
    const Index g = half_edge(links, 1, 2), h = half_edge(links, 2, 1);
    renumber(links, std::array{g, h}, std::array{h, g});
    CHECK(links.twin[g] == h);
    CHECK(links.twin[h] == g);
    renumber(links, std::array{g}, std::array{half_edge(links, 1, 4)});
    CHECK(links.twin[h] == half_edge(links, 1, 4));
    CHECK(links.closed[half_edge(links, 1, 4)] == 0);
    join(links, g, h);
    CHECK(links.twin[h] == g);
    CHECK(links.closed[g] == 0);
  }
}
