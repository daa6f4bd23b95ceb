#include "mesher/quads/systematic_merging.hpp"

#include <random>

#include <doctest/doctest.h>

#include "mesher/quads/pairing_candidates.hpp"
#include "tests/mesher/quads/pairing_support.hpp"

using namespace anisofront;
using namespace anisofront::testing;

TEST_SUITE("unit") {
  TEST_CASE("an even strip of triangles is merged whole from any end") {
    // One row of equilateral triangles: a wrong pair anywhere would leave odd ends.
    for (Index n = 1; n <= 12; ++n) {
      std::vector<Point> points;
      std::vector<Triangle> triangles;
      for (Index i = 0; i < 2 * n + 2; ++i)
        points.push_back({0.5 * i, i % 2 == 0 ? 0 : std::sqrt(3.) / 2});
      for (Index i = 0; i < 2 * n; ++i)
        triangles.push_back(i % 2 == 0 ? Triangle{i, i + 2, i + 1} : Triangle{i, i + 1, i + 2});
      const WorkMesh mesh = work_mesh(points, triangles);
      const std::vector<Index> mates = systematic_merging(mesh, merge_candidates(mesh));
      for (Index t = 0; t < 2 * n; ++t) CHECK(mates[t] == (t ^ 1));
    }
  }

  TEST_CASE("a part with an odd number of triangles keeps one") {
    const WorkMesh even = right_triangles(4, 3);
    CHECK(triangles_in(pair_triangles(even, {}, Pairing::systematic)) == 0);
    WorkMesh odd = even;
    const Index corner = 1;  // the upper left half of the first square has a neighbour less
    for (const Index n : odd.triangles[corner].neighbours)
      if (n >= 0) odd.triangles[n].neighbours[side_towards(odd.triangles[n], corner)] = ~0;
    odd.triangles[corner] = {};
    CHECK(triangles_in(pair_triangles(odd, {}, Pairing::systematic)) == 1);
  }
}

TEST_SUITE("property") {
  TEST_CASE("on meshes of the front hardly any triangle is left") {
    std::mt19937_64 random(3);
    Index triangles = 0, systematic = 0, in_order = 0;
    for (int i = 0; i < 4; ++i) {
      const KnownDomain known = star_domain(random);
      WorkCase work(known.domain, [](Point) { return metric_from_size(0.04); }, {-1.1, -1.1},
                    {1.1, 1.1});
      triangulate(work);
      triangles += live_triangles(work.mesh());
      systematic += triangles_in(pair_triangles(work.mesh(), {}, Pairing::systematic));
      in_order += triangles_in(pair_triangles(work.mesh(), {}, Pairing::beta_order));
    }
    CHECK(triangles > 5000);
    CHECK(systematic < triangles / 300);
    CHECK(systematic < in_order / 5);
  }
}
