#include "mesher/quads/quad_operations.hpp"

#include <doctest/doctest.h>

#include "tests/mesher/quads/quad_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// The half-edge from u to v.
Index edge_between(const QuadMesh& mesh, Index u, Index v) {
  for (const Index h : live_half_edges(mesh))
    if (mesh.corner[h] == u && mesh.corner[next_in_quad(h)] == v) return h;
  FAIL("no half-edge from " << u << " to " << v);
  return kNoIndex;
}

/// Commits and checks what every operation must keep.
void commit_and_check(QuadWork& work, const QuadMesh& before) {
  int not_convex = 0;
  work.energy_change(not_convex);
  work.commit();
  CHECK(broken_invariant(work.mesh) == "");
  CHECK(rim_of(work.mesh) == rim_of(before));
  CHECK(euler_number(work.mesh) == euler_number(before));
  CHECK(signed_area(work.mesh) == doctest::Approx(signed_area(before)).epsilon(1e-12));
}

}  // namespace

// Vertex j (n + 1) + i of an n x m grid lies at (i, j), its quadrilateral j n + i beside it.
TEST_SUITE("unit") {
  TEST_CASE("collapsing a diagonal merges two vertices in their middle") {
    UnitCase unit(plain_grid(3, 3));
    QuadWork& work = unit.work;
    const QuadMesh before = work.mesh;
    REQUIRE(collapse_diagonal(work, 16));  // the middle one 5 6 10 9: 5 and 10 merge
    CHECK(work.valence_growth() == 4 + 1 + 1);
    commit_and_check(work, before);
    CHECK(live_quads(work.mesh) == 8);
    CHECK(work.mesh.is_dead(4));
    CHECK(work.mesh.leaving[10] == kNoIndex);
    CHECK(work.mesh.vertices[5].p == Point{1.5, 1.5});
    CHECK(work.mesh.valence[5] == 6);
    CHECK(work.mesh.valence[6] == 3);
    CHECK(work.mesh.valence[9] == 3);
  }

  TEST_CASE("a boundary vertex survives the collapse in place") {
    for (const Index h : {0, 2}) {  // from the corner 0 or from the inner vertex 5
      UnitCase unit(plain_grid(3, 3));
      QuadWork& work = unit.work;
      const QuadMesh before = work.mesh;
      REQUIRE(collapse_diagonal(work, h));
      CHECK(work.valence_growth() == 4 + 1 + 1);
      commit_and_check(work, before);
      CHECK(work.mesh.leaving[5] == kNoIndex);
      CHECK(work.mesh.vertices[0].p == Point{0, 0});
      CHECK(work.mesh.valence[0] == 3);
      CHECK(work.mesh.valence[1] == 1);
      CHECK(work.mesh.valence[4] == 1);
    }
  }

  TEST_CASE("a required vertex survives the collapse in place") {
    MixedMesh grid = plain_grid(3, 3);
    grid.required[10] = 1;
    UnitCase unit(grid);
    const QuadMesh before = unit.work.mesh;
    REQUIRE(collapse_diagonal(unit.work, 16));
    commit_and_check(unit.work, before);
    CHECK(unit.work.mesh.leaving[5] == kNoIndex);
    CHECK(unit.work.mesh.vertices[10].p == Point{2, 2});
    CHECK(unit.work.mesh.valence[10] == 6);
  }

  TEST_CASE("vertices that must stay are never merged") {
    MixedMesh grid = plain_grid(3, 3);
    grid.required[5] = grid.required[10] = 1;
    UnitCase unit(grid);
    const QuadWork before = unit.work;
    CHECK_FALSE(collapse_diagonal(unit.work, 16));  // both required
    CHECK_FALSE(collapse_diagonal(unit.work, 1));   // 1 and 4 both on the boundary
    CHECK_FALSE(collapse_diagonal(unit.work, 0));   // the corner 0 and 5
    CHECK(difference(unit.work, before) == "");
  }

  TEST_CASE("vertices with a third common neighbour are never merged") {
    // 4 5 6 7 inside 0 1 2 3: the quadrilateral 4 5 6 8, and 4 8 6 7 around a smaller one, so that
    // 4 and 6 have 5 and 8 and 7 in common.
    MixedMesh mesh;
    for (const Point p : {Point{0, 0},
                          {4, 0},
                          {4, 4},
                          {0, 4},
                          {1, 1},
                          {3, 1},
                          {3, 3},
                          {1, 3},
                          {1.9, 2.1},
                          {1.3, 1.6},
                          {1.8, 2.2},
                          {2.3, 2.7},
                          {1.3, 2.7}})
      mesh.vertices.push_back({p, {}, 0});
    for (const Quad& q : {Quad{0, 1, 5, 4},
                          {1, 2, 6, 5},
                          {2, 3, 7, 6},
                          {3, 0, 4, 7},
                          {4, 5, 6, 8},
                          {9, 10, 11, 12},
                          {4, 8, 10, 9},
                          {8, 6, 11, 10},
                          {6, 7, 12, 11},
                          {7, 4, 9, 12}})
      mesh.faces.push_back({q});
    add_rim(mesh);
    UnitCase unit(mesh);
    QuadWork& work = unit.work;
    REQUIRE(broken_invariant(work.mesh) == "");
    const QuadWork before = work;
    CHECK_FALSE(collapse_diagonal(work, edge_between(work.mesh, 4, 5)));
    CHECK(difference(work, before) == "");
    CHECK(collapse_diagonal(work, edge_between(work.mesh, 5, 6)));
    commit_and_check(work, before.mesh);
  }

  TEST_CASE("rotating an edge moves a quadrilateral from its old ends to its new ones") {
    for (const int steps : {1, 2}) {
      UnitCase unit(plain_grid(4, 4));
      QuadWork& work = unit.work;
      const QuadMesh before = work.mesh;
      REQUIRE(rotate_edge(work, edge_between(work.mesh, 12, 13), steps));
      CHECK(work.valence_growth() == 4);
      commit_and_check(work, before);
      CHECK(live_quads(work.mesh) == 16);
      const Index from = steps == 1 ? 18 : 17, to = steps == 1 ? 7 : 8;
      CHECK(are_adjacent(work.mesh, from, to));
      CHECK_FALSE(are_adjacent(work.mesh, 12, 13));
      CHECK(work.mesh.valence[12] == 3);
      CHECK(work.mesh.valence[13] == 3);
      CHECK(work.mesh.valence[from] == 5);
      CHECK(work.mesh.valence[to] == 5);
    }
  }

  TEST_CASE("rotating an edge on twice more brings it back") {
    UnitCase unit(plain_grid(4, 4));
    QuadWork& work = unit.work;
    REQUIRE(rotate_edge(work, edge_between(work.mesh, 12, 13), 1));
    work.commit();
    REQUIRE(rotate_edge(work, edge_between(work.mesh, 18, 7), 2));
    work.commit();
    CHECK(broken_invariant(work.mesh) == "");
    CHECK(are_adjacent(work.mesh, 12, 13));
    CHECK(std::count(work.mesh.valence.begin(), work.mesh.valence.end(), 4) == 9);
  }

  TEST_CASE("an edge is not rotated to join two boundary vertices or a segment") {
    UnitCase unit(plain_grid(2, 2));
    QuadWork& work = unit.work;
    const QuadWork before = work;
    for (const int steps : {1, 2}) {
      CHECK_FALSE(rotate_edge(work, edge_between(work.mesh, 4, 5), steps));  // 1-8 or 2-7
      CHECK_FALSE(rotate_edge(work, edge_between(work.mesh, 0, 1), steps));  // on a segment
    }
    CHECK(difference(work, before) == "");
  }

  TEST_CASE("a vertex that rotating an edge leaves with two quadrilaterals goes") {
    UnitCase unit(plain_grid(4, 4));
    QuadWork& work = unit.work;
    REQUIRE(rotate_edge(work, edge_between(work.mesh, 12, 13), 1));  // 12 has three left
    commit_and_check(work, unit.work.mesh);
    const QuadMesh before = work.mesh;
    REQUIRE(rotate_edge(work, edge_between(work.mesh, 12, 17), 1));
    commit_and_check(work, before);
    CHECK(work.mesh.leaving[12] == kNoIndex);
    CHECK(live_quads(work.mesh) == 15);
  }

  TEST_CASE("what would leave a required vertex with two quadrilaterals is refused") {
    MixedMesh grid = plain_grid(4, 4);
    grid.required[12] = 1;
    UnitCase unit(grid);
    QuadWork& work = unit.work;
    REQUIRE(rotate_edge(work, edge_between(work.mesh, 12, 13), 1));
    commit_and_check(work, unit.work.mesh);
    const QuadWork before = work;
    CHECK_FALSE(rotate_edge(work, edge_between(work.mesh, 12, 17), 1));
    CHECK(difference(work, before) == "");
  }

  TEST_CASE("splitting a vertex adds a quadrilateral between its halves") {
    UnitCase unit(plain_grid(4, 4));
    QuadWork& work = unit.work;
    const QuadMesh before = work.mesh;
    REQUIRE(split_vertex(work, edge_between(work.mesh, 12, 13), 2));  // 13 and 11 stay on both
    CHECK(work.valence_growth() == 4);
    commit_and_check(work, before);
    CHECK(live_quads(work.mesh) == 17);
    CHECK(live_vertices(work.mesh) == 26);
    CHECK(work.mesh.valence[12] == 3);
    CHECK(work.mesh.valence[25] == 3);
    CHECK(work.mesh.valence[13] == 5);
    CHECK(work.mesh.valence[11] == 5);
    CHECK(are_adjacent(work.mesh, 12, 17));  // the first two anticlockwise stay with 12
    CHECK(are_adjacent(work.mesh, 25, 7));
    CHECK(work.mesh.vertices[12].p.y > 2);
    CHECK(work.mesh.vertices[25].p.y < 2);
  }

  TEST_CASE("collapsing the quadrilateral of a split undoes it") {
    UnitCase unit(plain_grid(4, 4));
    QuadWork& work = unit.work;
    REQUIRE(split_vertex(work, edge_between(work.mesh, 12, 13), 2));
    commit_and_check(work, unit.work.mesh);
    REQUIRE(collapse_diagonal(work, edge_between(work.mesh, 12, 11)));
    commit_and_check(work, unit.work.mesh);
    CHECK(live_quads(work.mesh) == 16);
    CHECK(std::count(work.mesh.valence.begin(), work.mesh.valence.end(), 4) == 9);
  }

  TEST_CASE("no split leaves a vertex inside with two quadrilaterals") {
    UnitCase unit(l_shape());
    QuadWork& work = unit.work;
    const QuadWork before = work;
    for (const int count : {-1, 0, 1, 3, 4})
      CHECK_FALSE(split_vertex(work, work.mesh.leaving[8], count));
    for (const int begin : {0, 1, 2})
      CHECK_FALSE(split_boundary_vertex(work, 24, begin, begin + 1));
    CHECK(difference(work, before) == "");
  }

  TEST_CASE("vertices of the wrong kind and sectors out of range are not split") {
    MixedMesh grid = l_shape();
    grid.required[8] = 1;
    UnitCase unit(grid);
    QuadWork& work = unit.work;
    const QuadWork before = work;
    CHECK_FALSE(split_vertex(work, work.mesh.leaving[24], 2));
    CHECK_FALSE(split_vertex(work, work.mesh.leaving[8], 2));
    CHECK_FALSE(rotate_vertex(work, 8));
    CHECK_FALSE(rotate_vertex(work, 24));
    CHECK_FALSE(split_boundary_vertex(work, 9, 0, 2));
    CHECK_FALSE(split_boundary_vertex(work, 24, -1, 2));
    CHECK_FALSE(split_boundary_vertex(work, 24, 1, 4));
    CHECK_FALSE(split_boundary_vertex(work, 24, 2, 1));
    CHECK_FALSE(split_boundary_vertex(work, 24, 2, 2));
    CHECK(difference(work, before) == "");
  }

  TEST_CASE("a split at an end of the fan puts a side of the new quadrilateral on the boundary") {
    // The re-entrant corner 24 at (3, 3): its fan runs from 31 at (3, 4) over 23 and 17 to 25.
    for (const bool at_begin : {true, false}) {
      CAPTURE(at_begin);
      UnitCase unit(l_shape());
      QuadWork& work = unit.work;
      const QuadMesh before = work.mesh;
      REQUIRE(split_boundary_vertex(work, 24, at_begin ? 0 : 1, at_begin ? 2 : 3));
      const Index rim = at_begin ? 31 : 25, other = at_begin ? 25 : 31;
      const Index inner = at_begin ? 17 : 23, w = static_cast<Index>(before.vertices.size());
      CHECK(work.valence_growth() == 1 + 1 + 1 + 1);
      commit_and_check(work, before);
      CHECK(live_quads(work.mesh) == 28);
      CHECK(work.mesh.valence[24] == 2);
      CHECK(work.mesh.valence[w] == 3);
      CHECK(work.mesh.valence[rim] == 3);
      CHECK(work.mesh.valence[other] == 2);
      CHECK(work.mesh.valence[inner] == 5);
      CHECK(work.mesh.vertices[24].p == Point{3, 3});
      CHECK(work.mesh.is_free(w));
      CHECK(are_adjacent(work.mesh, w, rim));
      CHECK(are_adjacent(work.mesh, w, inner));
      CHECK_FALSE(are_adjacent(work.mesh, w, 24));
    }
  }

  TEST_CASE("rotating a vertex joins it with the opposite corners") {
    UnitCase unit(plain_grid(4, 4));
    QuadWork& work = unit.work;
    const QuadMesh before = work.mesh;
    REQUIRE(rotate_vertex(work, 12));
    CHECK(work.valence_growth() == 4 + 4);
    commit_and_check(work, before);
    CHECK(live_quads(work.mesh) == 16);
    CHECK(work.mesh.valence[12] == 4);
    for (const Index v : {6, 8, 16, 18}) {
      CHECK(work.mesh.valence[v] == 5);
      CHECK(are_adjacent(work.mesh, 12, v));
    }
    for (const Index v : {7, 11, 13, 17}) {
      CHECK(work.mesh.valence[v] == 3);
      CHECK_FALSE(are_adjacent(work.mesh, 12, v));
    }
  }

  TEST_CASE("a doublet of a fresh mesh is removed") {
    MixedMesh mesh;
    for (const Point p : {Point{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.4}})
      mesh.vertices.push_back({p, {}, 0});
    mesh.faces = {{{4, 3, 0, 1}}, {{4, 1, 2, 3}}};
    add_rim(mesh);
    UnitCase unit(mesh);
    const QuadMesh before = unit.work.mesh;
    CHECK(broken_invariant(before) == "vertex 4 is a doublet");
    remove_doublets(unit.work);
    CHECK(broken_invariant(unit.work.mesh) == "");
    CHECK(live_quads(unit.work.mesh) == 1);
    CHECK(unit.work.mesh.leaving[4] == kNoIndex);
    CHECK(rim_of(unit.work.mesh) == rim_of(before));
    CHECK(unit.work.energy_of(quad_of(live_half_edges(unit.work.mesh)[0])).value ==
          doctest::Approx(0).epsilon(1e-12));
  }

  TEST_CASE("a doublet that is required stays") {
    MixedMesh mesh;
    for (const Point p : {Point{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.4}})
      mesh.vertices.push_back({p, {}, 0});
    mesh.faces = {{{4, 3, 0, 1}}, {{4, 1, 2, 3}}};
    mesh.required = {0, 0, 0, 0, 1};
    add_rim(mesh);
    UnitCase unit(mesh);
    const QuadWork before = unit.work;
    remove_doublets(unit.work);
    CHECK(difference(unit.work, before) == "");
  }
}
