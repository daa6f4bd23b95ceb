#include "solver/plate/nearest_vertex.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/plate/plate_cases.hpp"

using namespace anisofront;
using namespace anisofront::test;

TEST_SUITE("unit") {
  TEST_CASE("the nearest vertex is found and equal distances go to the smaller number") {
    const Mesh mesh = square_mesh(2);  // vertex 3 j + i at (i/2, j/2)
    const FeMesh fe = straight_fe_mesh(mesh);
    CHECK(nearest_vertex(fe, {0.6, 0.1}, "the load") == 1);
    CHECK(nearest_vertex(fe, {0.25, 0.25}, "the load") == 0);
    CHECK(nearest_vertex(fe, {1, 1}, "the load") == 8);
  }

  TEST_CASE("vertices that no element has are passed over") {
    Mesh mesh = square_mesh(2);
    mesh.points.push_back({0.6, 0.1});
    CHECK(nearest_vertex(straight_fe_mesh(mesh), {0.6, 0.1}, "the load") == 1);
  }

  TEST_CASE("points outside the mesh are refused") {
    const Mesh mesh = square_mesh(2);
    CHECK_THROWS_WITH_AS(
        nearest_vertex(straight_fe_mesh(mesh), {1.1, 0.5}, "the point load"),
        "the point load at (1.1, 0.5) lies outside the mesh, which reaches from (0, 0) to (1, 1)",
        InputError);
  }
}
