#include "mesher/enhance/patch.hpp"

#include <algorithm>
#include <set>

#include <doctest/doctest.h>

#include "tests/support/work_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

MetricFunction size(double h) {
  return [h](Point) { return metric_from_size(h); };
}

Domain square_with_slit() {
  Domain domain = square_domain(1);
  domain.regions[0].embedded_curves.push_back(
      add_curve(domain, "slit", 9, make_line({0.3, 0.5}, {0.7, 0.5})));
  return domain;
}

std::set<Index> triangles_with(const WorkMesh& mesh, Index v) {
  std::set<Index> found;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
    for (const Index w : mesh.triangles[t].vertices)
      if (w == v) found.insert(t);
  return found;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("vertices on segments and required ones are fixed and all are active") {
    WorkCase work(square_domain(1), size(0.25), {0, 0}, {1, 1});
    work.advance();
    const auto boundary = static_cast<Index>(work.mesh().segments.size());
    const auto last = static_cast<Index>(work.mesh().vertices.size()) - 1;
    REQUIRE(last > boundary);
    const Patch patch = make_patch(*work.background, work.mesh(), {last});
    CHECK(std::count(patch.fixed.begin(), patch.fixed.end(), 1) == boundary + 1);
    CHECK(patch.fixed[last] == 1);
    CHECK(std::count(patch.active.begin(), patch.active.end(), 1) == last + 1);
    CHECK(broken_invariant(patch) == "");
    for (Index t = 0; t < static_cast<Index>(work.mesh().triangles.size()); ++t)
      CHECK(patch.alpha[t] == doctest::Approx(patch.alpha_of(t)).epsilon(1e-6));
  }

  TEST_CASE("the ring of an interior vertex goes round it once") {
    WorkCase work(square_with_slit(), size(0.1), {0, 0}, {1, 1});
    work.advance();
    const Patch patch = make_patch(*work.background, work.mesh(), {});
    Ring ring;
    int interior = 0;
    for (Index v = 0; v < static_cast<Index>(work.mesh().vertices.size()); ++v) {
      if (patch.fixed[v]) {
        CHECK_FALSE(closed_ring(patch, v, ring));
        continue;
      }
      ++interior;
      REQUIRE(closed_ring(patch, v, ring));
      CHECK(ring.closed);
      CHECK(ring.vertex_count() == ring.size);
      CHECK(ring.vertices[ring.size] == ring.vertices[0]);
      const std::set<Index> around(ring.triangles.begin(), ring.triangles.begin() + ring.size);
      CHECK(around == triangles_with(work.mesh(), v));
      for (int i = 0; i < ring.size; ++i)
        CHECK(orientation(patch.point(v), patch.point(ring.vertices[i]),
                          patch.point(ring.vertices[i + 1])) > 0);
    }
    CHECK(interior > 50);
  }

  TEST_CASE("the fans of a boundary vertex hold each of its triangles once") {
    WorkCase work(square_with_slit(), size(0.1), {0, 0}, {1, 1});
    work.advance();
    const Patch patch = make_patch(*work.background, work.mesh(), {});
    int with_two_fans = 0;
    for (Index v = 0; v < static_cast<Index>(work.mesh().vertices.size()); ++v) {
      const std::set<Index> all = triangles_with(work.mesh(), v);
      std::set<Index> seen;
      int fans = 0;
      Ring ring;
      for (const Index t : all) {
        if (seen.count(t)) continue;
        ++fans;
        REQUIRE(fan_through(patch, v, t, ring));
        CHECK(ring.closed == !patch.fixed[v]);
        CHECK(ring.vertex_count() == ring.size + (patch.fixed[v] ? 1 : 0));
        for (int i = 0; i < ring.size; ++i) CHECK(seen.insert(ring.triangles[i]).second);
      }
      CHECK(seen == all);
      CHECK(fans <= 2);
      with_two_fans += fans == 2 ? 1 : 0;
    }
    CHECK(with_two_fans == 3);  // the slit of four segments has three inner vertices
  }

  TEST_CASE("rings above the capacity are refused") {
    // A disc of 80 fine sides around one vertex.
    WorkMesh mesh;
    const Index n = 80;
    mesh.vertices.push_back({{0, 0}, {}, 0});
    for (Index i = 0; i < n; ++i) {
      const double phi = 2 * kPi * i / n;
      mesh.vertices.push_back({{std::cos(phi), std::sin(phi)}, {}, 0});
      mesh.segments.push_back({i + 1, (i + 1) % n + 1, 0, 0, 1, 0, kNoIndex});
      mesh.triangles.push_back({{0, i + 1, (i + 1) % n + 1}, {~i, (i + 1) % n, (i + n - 1) % n}});
    }
    REQUIRE(broken_invariant(mesh) == "");
    const Mesh grid = crossed_rectangle(2, 2, {-1, -1}, {1, 1});
    const BackgroundMesh background(grid, MetricField(grid.points.size()));
    const Patch patch = make_patch(background, mesh, {});
    Ring ring;
    CHECK_FALSE(closed_ring(patch, 0, ring));
    CHECK_FALSE(fan_through(patch, 0, 5, ring));
    CHECK(fan_through(patch, 7, patch.triangle_of[7], ring));
    CHECK(ring.size == 2);
  }
}
