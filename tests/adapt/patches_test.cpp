#include "adapt/patches.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

std::vector<Index> patch(const Mesh& mesh, Index v, bool by_region = false, Index region = 0,
                         bool drop_interfaces = false) {
  const PatchTopology topology(mesh, by_region);
  PatchCollector collector(topology);
  collector.around(0, 0, false);  // the scratch of another patch does no harm
  const auto around = collector.around(v, region, drop_interfaces);
  return {around.begin(), around.end()};
}

bool has(const std::vector<Index>& patch, Index v) {
  return std::find(patch.begin(), patch.end(), v) != patch.end();
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("on triangles the patch is the two-ring and begins with its vertex") {
    const auto around = patch(square_mesh(8), 40);  // valences six: 1 + 6 + 12
    CHECK(around.size() == 19);
    CHECK(around[0] == 40);
    CHECK(has(around, 40 + 2 * 10));       // along the diagonals of the cells
    CHECK_FALSE(has(around, 40 + 2 * 8));  // across them
  }

  TEST_CASE("on quadrilaterals the patch is a square of 25 without its corners") {
    const auto around = patch(square_quads(8, 8), 40);
    CHECK(around.size() == 21);
    CHECK(has(around, 42));
    CHECK_FALSE(has(around, 40 + 2 * 9 + 2));
  }

  TEST_CASE("patches of few vertices in corners grow by another ring") {
    CHECK(patch(square_mesh(8), 8).size() >= 10);  // two rings hold six
    CHECK(patch(square_quads(8, 8), 0).size() >= 10);
    CHECK(patch(square_mesh(1), 0).size() == 4);  // nothing more to add
  }

  TEST_CASE("patches by region stay on their side and leave out interfaces when asked to") {
    Mesh mesh = square_mesh(8);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      mesh.triangle_regions[t] = mesh.points[mesh.triangles[t][0]].x < 0.5 &&
                                         mesh.points[mesh.triangles[t][1]].x <= 0.5 &&
                                         mesh.points[mesh.triangles[t][2]].x <= 0.5
                                     ? 4
                                     : 7;
    const PatchTopology topology(mesh, true);
    CHECK(topology.is_on_interface(40));
    CHECK_FALSE(topology.is_on_interface(39));
    CHECK(topology.regions_at(40) == std::vector<Index>{4, 7});
    for (const Index v : patch(mesh, 40, true, 4)) CHECK(mesh.points[v].x <= 0.5);
    for (const Index v : patch(mesh, 40, true, 7)) CHECK(mesh.points[v].x >= 0.5);
    const auto inside = patch(mesh, 40, true, 7, true);
    CHECK(inside.size() >= 10);
    for (const Index v : inside) CHECK(mesh.points[v].x > 0.5);
  }
}
