#include "mesher/quads/quad_mesh.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/mesher/quads/quad_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Quadrilaterals that begin at their smallest vertex, sorted.
std::vector<Quad> normalised(std::vector<Quad> quads) {
  for (Quad& q : quads) std::rotate(q.begin(), std::min_element(q.begin(), q.end()), q.end());
  std::sort(quads.begin(), quads.end());
  return quads;
}

Index vertex_count(const QuadMesh& mesh) { return static_cast<Index>(mesh.vertices.size()); }

int copies_of(const QuadMesh& mesh, Index v) {
  return static_cast<int>(std::count(mesh.original.begin(), mesh.original.end(), v));
}

/// n quadrilaterals around vertex 0.
MixedMesh star(Index n) {
  MixedMesh mesh;
  mesh.vertices.push_back({});
  for (Index i = 0; i < 2 * n; ++i) {
    const double phi = 3.141592653589793 * i / n;
    mesh.vertices.push_back({{std::cos(phi), std::sin(phi)}, {}, 0});
  }
  const auto around = [&](Index i) { return 1 + i % (2 * n); };
  for (Index i = 0; i < 2 * n; i += 2)
    mesh.faces.push_back({{0, around(i), around(i + 1), around(i + 2)}});
  add_rim(mesh);
  return mesh;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a grid has rings of 4 inside and fans of 1 and 2 on its rim") {
    const QuadMesh mesh = make_quad_mesh(plain_grid(3, 3));
    CHECK(broken_invariant(mesh) == "");
    CHECK(vertex_count(mesh) == 16);
    CHECK(mesh.quad_count() == 9);
    CHECK(euler_number(mesh) == 1);
    CHECK(rim_of(mesh).size() == 12);
    const std::vector<std::uint8_t> valences{1, 2, 2, 1, 2, 4, 4, 2, 2, 4, 4, 2, 1, 2, 2, 1};
    CHECK(mesh.valence == valences);
    for (Index v = 0; v < 16; ++v) {
      CHECK(mesh.is_free(v) == (mesh.valence[v] == 4));
      CHECK(mesh.original[v] == v);
    }
  }

  TEST_CASE("an edge between two boundary vertices is not on the boundary for that") {
    const QuadMesh mesh = make_quad_mesh(plain_grid(2, 1));
    CHECK(broken_invariant(mesh) == "");
    CHECK(vertex_count(mesh) == 6);
    CHECK(rim_of(mesh).size() == 6);
    CHECK(euler_number(mesh) == 1);
    CHECK(mesh.valence == std::vector<std::uint8_t>{1, 2, 1, 1, 2, 1});
  }

  TEST_CASE("half-edges lead around quadrilaterals and around vertices") {
    const QuadMesh mesh = make_quad_mesh(plain_grid(3, 3));
    const Index h = 16;  // 5 -> 6 of the quadrilateral 5 6 10 9
    CHECK(mesh.corner[h] == 5);
    CHECK(mesh.corner[next_in_quad(h)] == 6);
    CHECK(mesh.corner[opposite_in_quad(h)] == 10);
    CHECK(mesh.corner[previous_in_quad(h)] == 9);
    CHECK(next_in_quad(previous_in_quad(h)) == h);
    CHECK(previous_in_quad(16) == 19);
    CHECK(quad_of(19) == 4);
    Index g = h;
    for (const Index neighbour : {9, 4, 1, 6}) {
      CHECK(clockwise(mesh, anticlockwise(mesh, g)) == g);
      g = anticlockwise(mesh, g);
      CHECK(mesh.corner[g] == 5);
      CHECK(mesh.corner[next_in_quad(g)] == neighbour);
    }
    CHECK(g == h);
  }

  TEST_CASE("a fan runs from its first boundary edge to its last") {
    const QuadMesh mesh = make_quad_mesh(plain_grid(3, 3));
    std::vector<Index> neighbours;
    for_each_leaving(mesh, 1, [&](Index h) { neighbours.push_back(mesh.corner[next_in_quad(h)]); });
    CHECK(neighbours == std::vector<Index>{2, 5});
    CHECK(clockwise(mesh, mesh.leaving[1]) < 0);
  }

  TEST_CASE("edges on the rim join neighbours from either end") {
    const QuadMesh mesh = make_quad_mesh(plain_grid(3, 3));
    for (const auto& [u, v] : {std::pair{0, 1}, {0, 4}, {5, 6}, {5, 9}, {2, 3}}) {
      CHECK(are_adjacent(mesh, u, v));
      CHECK(are_adjacent(mesh, v, u));
    }
    CHECK_FALSE(are_adjacent(mesh, 0, 5));
    CHECK_FALSE(are_adjacent(mesh, 5, 10));
  }

  TEST_CASE("an interface cuts the mesh in two") {
    const MixedMesh mixed = grid_with_path(6, 4, {3, 10, 17, 24, 31});
    const QuadMesh mesh = make_quad_mesh(mixed);
    CHECK(broken_invariant(mesh) == "");
    CHECK(vertex_count(mesh) == 35 + 5);
    CHECK(euler_number(mesh) == 2);
    for (const Index v : {3, 10, 17, 24, 31}) CHECK(copies_of(mesh, v) == 2);
    CHECK(mesh.valence[10] == 2);
    CHECK(mesh.valence[3] == 1);
    for (Index v = 35; v < 40; ++v) {
      CHECK(mesh.on_boundary(v));
      CHECK(mesh.vertices[v].p == mesh.vertices[mesh.original[v]].p);
    }
    CHECK(rim_of(mesh).size() == 20 + 2 * 4);
  }

  TEST_CASE("interfaces that cross make one copy per quadrant") {
    const QuadMesh mesh = make_quad_mesh(crossing());
    CHECK(broken_invariant(mesh) == "");
    CHECK(vertex_count(mesh) == 49 + 12 + 3);
    CHECK(copies_of(mesh, 24) == 4);
    CHECK(euler_number(mesh) == 4);
  }

  TEST_CASE("a crack has two sides and one tip") {
    const QuadMesh mesh = make_quad_mesh(grid_with_path(6, 6, {3, 10, 17, 24}));
    CHECK(broken_invariant(mesh) == "");
    CHECK(vertex_count(mesh) == 49 + 3);
    CHECK(euler_number(mesh) == 1);
    for (const Index v : {3, 10, 17}) CHECK(copies_of(mesh, v) == 2);
    CHECK(copies_of(mesh, 24) == 1);
    CHECK(mesh.on_boundary(24));
    CHECK(mesh.valence[24] == 4);
    CHECK(mesh.twin[mesh.leaving[24]] < 0);
  }

  TEST_CASE("an embedded curve opens a slit") {
    const QuadMesh two = make_quad_mesh(grid_with_path(6, 6, {23, 24, 25}));
    CHECK(vertex_count(two) == 49 + 1);
    CHECK(copies_of(two, 24) == 2);
    CHECK(euler_number(two) == 0);
    const QuadMesh one = make_quad_mesh(grid_with_path(6, 6, {23, 24}));
    CHECK(vertex_count(one) == 49);
    CHECK(euler_number(one) == 0);
    CHECK(rim_of(one).size() == 24 + 2);
  }

  TEST_CASE("parts that meet in one vertex get a copy of it each") {
    MixedMesh mixed = quad_grid(2, 2, [](Index i, Index j) { return i != j; });
    add_rim(mixed);
    const QuadMesh mesh = make_quad_mesh(mixed);
    CHECK(broken_invariant(mesh) == "");
    CHECK(copies_of(mesh, 4) == 2);
    CHECK(mesh.valence[4] == 1);
    CHECK(mesh.valence[9] == 1);
    CHECK(euler_number(mesh) == 2);
    CHECK(mesh.leaving[2] == kNoIndex);  // a vertex of no quadrilateral
  }

  TEST_CASE("required vertices are required inside and boundary on a segment") {
    MixedMesh mixed = plain_grid(3, 3);
    mixed.required[1] = mixed.required[5] = 1;
    const QuadMesh mesh = make_quad_mesh(mixed);
    CHECK(mesh.on_boundary(1));
    CHECK(mesh.kind[5] == QuadVertexKind::required);
    CHECK(mesh.is_free(6));
    mixed.required.clear();  // none at all
    CHECK(make_quad_mesh(mixed).is_free(5));
  }

  TEST_CASE("quadrilaterals that do not fit together are refused") {
    MixedMesh mixed = plain_grid(2, 2);
    std::reverse(mixed.faces[1].vertices.begin(), mixed.faces[1].vertices.end());
    CHECK_THROWS_AS(make_quad_mesh(mixed), MeshingError);
    mixed = plain_grid(2, 2);
    mixed.faces.push_back(mixed.faces[0]);
    CHECK_THROWS_AS(make_quad_mesh(mixed), MeshingError);
  }

  TEST_CASE("at most 255 quadrilaterals may meet in a vertex") {
    const QuadMesh mesh = make_quad_mesh(star(255));
    CHECK(mesh.valence[0] == 255);
    CHECK(broken_invariant(mesh) == "");
    CHECK_THROWS_AS(make_quad_mesh(star(256)), MeshingError);
  }

  TEST_CASE("a mesh without quadrilaterals stays empty") {
    const QuadMesh mesh = make_quad_mesh({});
    CHECK(mesh.quad_count() == 0);
    CHECK(glued(mesh, {}).faces.empty());
  }

  TEST_CASE("cutting open and gluing gives the same mesh") {
    for (const NamedMesh& named : property_meshes()) {
      CAPTURE(named.name);
      const MixedMesh& mixed = named.mesh;
      const QuadMesh mesh = make_quad_mesh(mixed);
      CHECK(broken_invariant(mesh) == "");
      CHECK(live_quads(mesh) == static_cast<Index>(mixed.faces.size()));
      const MixedMesh again = glued(mesh, mixed.segments);
      CHECK(normalised(quads_of(again)) == normalised(quads_of(mixed)));
      CHECK(again.segments.size() == mixed.segments.size());
      CHECK(again.required == mixed.required);
      CHECK(std::equal(again.vertices.begin(), again.vertices.end(), mixed.vertices.begin(),
                       mixed.vertices.end(), same_vertex));
    }
  }

  TEST_CASE("new vertices follow the old ones when the mesh is glued") {
    UnitCase unit(grid_with_path(6, 6, {3, 10, 17, 24}));  // with three copies, 49 to 51
    QuadWork& work = unit.work;
    REQUIRE(split_vertex(work, work.mesh.leaving[8], 2));
    work.commit();
    REQUIRE(work.mesh.original[52] == kNoIndex);
    REQUIRE(collapse_diagonal(work, 4 * 35));  // the upper right quadrilateral goes
    work.commit();
    const MixedMesh again = glued(work.mesh, {});
    CHECK(again.vertices.size() == 50);
    CHECK(again.vertices[49].p == work.mesh.vertices[52].p);
    CHECK(again.faces.size() == 36);
    CHECK(again.required.size() == 50);
    for (const MixedFace& face : again.faces)
      for (const Index v : face.vertices) CHECK((v >= 0 && v < 50 && v != 40));
    const QuadMesh cut = make_quad_mesh([&] {
      MixedMesh m = again;
      m.segments = grid_with_path(6, 6, {3, 10, 17, 24}).segments;
      return m;
    }());
    CHECK(broken_invariant(cut) == "");
    CHECK(euler_number(cut) == 1);
  }
}
