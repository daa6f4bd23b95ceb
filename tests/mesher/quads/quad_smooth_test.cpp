#include "mesher/quads/quad_smooth.hpp"

#include <doctest/doctest.h>

#include "tests/mesher/quads/quad_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Squares of a constant metric, in the unit square's coordinates and in the plane.
struct MetricFrame {
  double h1, h2;
  Vector e1;
  Point operator()(Point p) const { return h1 * p.x * e1 + h2 * p.y * Vector{-e1.y, e1.x}; }
  Metric metric() const { return metric_from_sizes(h1, h2, e1); }
};

MixedMesh mapped(MixedMesh mesh, const MetricFrame& frame) {
  for (WorkVertex& v : mesh.vertices) v.p = frame(v.p);
  return mesh;
}

/// Greatest distance, in the metric, between equal vertices.
double displacement(const QuadMesh& mesh, const MixedMesh& ideal, const Metric& metric) {
  double most = 0;
  for (std::size_t v = 0; v < ideal.vertices.size(); ++v)
    most = std::max(most, length(metric, mesh.vertices[v].p - ideal.vertices[v].p));
  return most;
}

/// One call stops where single moves are below 0.02, a few of them away from the goal; the next
/// call looks at all vertices again.
void smooth_until_still(QuadWork& work, const SearchOptions& options, const MixedMesh& ideal,
                        const Metric& metric) {
  smooth_all(work, 60, options);
  CHECK(displacement(work.mesh, ideal, metric) < 0.12);
  for (int call = 0; call < 40; ++call) smooth_all(work, 60, options);
  CHECK(displacement(work.mesh, ideal, metric) < 0.02);
}

void check_energies(const QuadWork& work) {
  for (Index q = 0; q < work.mesh.quad_count(); ++q)
    if (!work.mesh.is_dead(q)) {
      CHECK(work.energy[q] == work.energy_of(q).value);
      CHECK((work.convex[q] != 0) == work.energy_of(q).convex);
    }
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a perturbed grid of squares returns to squares") {
    const SearchOptions plain{.first_step = 0.2, .last_step = 0.005};
    SearchOptions few = plain;
    few.repeat = few.ideal_point = false;
    for (const SearchOptions& options : {plain, few})
      for (const unsigned seed : {1u, 2u, 3u}) {
        CAPTURE(seed);
        CAPTURE(options.repeat);
        std::mt19937_64 random(seed);
        MixedMesh mesh = plain_grid(6, 6);
        perturb(mesh, random, 0.3);
        UnitCase unit(mesh);
        smooth_until_still(unit.work, options, plain_grid(6, 6), Metric{});
        check_energies(unit.work);
      }
  }

  TEST_CASE("so does one of thin rectangles in a metric with a stretch of 50") {
    const double pi6 = 0.5235987755982988;
    const MetricFrame frame{0.02, 1, {std::cos(pi6), std::sin(pi6)}};
    const BackgroundMesh background =
        background_of([&](Point) { return frame.metric(); }, {-7, -7}, {7, 7});
    for (const unsigned seed : {1u, 2u, 3u}) {
      CAPTURE(seed);
      std::mt19937_64 random(seed);
      MixedMesh mesh = plain_grid(6, 6);
      perturb(mesh, random, 0.3);
      QuadWork work = work_on(background, mapped(mesh, frame));
      smooth_until_still(work, {.first_step = 0.2, .last_step = 0.005},
                         mapped(plain_grid(6, 6), frame), frame.metric());
      check_energies(work);
    }
  }

  TEST_CASE("vertices on segments and required ones stay to the bit") {
    std::mt19937_64 random(5);
    for (NamedMesh& named : property_meshes()) {
      CAPTURE(named.name);
      MixedMesh mesh = named.mesh;
      perturb(mesh, random, 0.3);
      UnitCase unit(mesh);
      const QuadMesh before = unit.work.mesh;
      smooth_all(unit.work, 5, {});
      bool moved = false;
      for (std::size_t v = 0; v < before.vertices.size(); ++v) {
        const bool same = same_vertex(unit.work.mesh.vertices[v], before.vertices[v]);
        if (before.kind[v] != QuadVertexKind::free) CHECK(same);
        moved = moved || !same;
      }
      CHECK(moved);
      CHECK(unit.work.mesh.corner == before.corner);
      CHECK(unit.work.mesh.twin == before.twin);
      check_energies(unit.work);
    }
  }

  TEST_CASE("a mesh without anything to gain keeps every bit") {
    UnitCase unit(plain_grid(5, 5));
    const QuadWork before = unit.work;
    smooth_all(unit.work, 5, {});
    CHECK(difference(unit.work, before) == "");
  }

  TEST_CASE("a better place is found without changing the mesh") {
    MixedMesh mesh = plain_grid(4, 4);
    mesh.vertices[12].p = {2.3, 1.8};
    UnitCase unit(mesh);
    const QuadWork before = unit.work;
    QuadSmoother smoother(unit.work);
    WorkVertex better;
    REQUIRE(smoother.improve(12, {.first_step = 0.2, .last_step = 0.001}, better));
    CHECK(norm(better.p - Point{2, 2}) < 0.01);
    CHECK(difference(unit.work, before) == "");
    unit.work.mesh.vertices[12] = better;
    CHECK(total_energy(unit.work) < total_energy(before));
    unit.work.mesh.vertices[12].p = {2, 2};
    CHECK_FALSE(smoother.improve(12, {}, better));
  }

  TEST_CASE("the ideal points of Eqn 27 are tried first") {
    // In the frame six of the eight quarter turns around 12 lead to (2, 2). 18 at (3.75, 3) turns
    // (0.75, 1) of length 1.25 about 13 into (-0.8, 0.6), and (1.75, 0) about 17 into (0, -1.3125),
    // as 1.75 is brought down by 4/3 only: (2.2, 2.6) and (2, 1.6875) instead of twice (2, 2).
    const MetricFrame frame{0.1, 2, {0.6, 0.8}};
    const BackgroundMesh background =
        background_of([&](Point) { return frame.metric(); }, {-9, -9}, {9, 9});
    MixedMesh mesh = plain_grid(4, 4);
    mesh.vertices[12].p = {2.4, 1.7};
    mesh.vertices[18].p = {3.75, 3};
    QuadWork work = work_on(background, mapped(mesh, frame));
    WorkVertex better;
    // A first step below the last one leaves the ideal point as the only trial.
    REQUIRE(QuadSmoother(work).improve(12, {.first_step = 0.1, .last_step = 0.2}, better));
    CHECK(length(frame.metric(), better.p - frame({2.025, 2.0359375})) < 1e-9);
  }

  TEST_CASE("the metric of a moved vertex is that of its new place") {
    const auto growing = [](Point p) { return metric_from_size(0.7 + 0.1 * p.x); };
    const BackgroundMesh background = background_of(growing, {0, 0}, {6, 6});
    std::mt19937_64 random(3);
    MixedMesh mesh = plain_grid(6, 6);
    perturb(mesh, random, 0.3);
    QuadWork work = work_on(background, mesh);
    smooth_all(work, 4, {});
    for (const WorkVertex& v : work.mesh.vertices)
      CHECK(v.r.a == doctest::Approx(1 / (0.7 + 0.1 * v.p.x)).epsilon(1e-9));
  }

  TEST_CASE("a concave quadrilateral becomes convex") {
    MixedMesh mesh = plain_grid(4, 4);
    mesh.vertices[12].p = {3.2, 2.9};
    UnitCase unit(mesh);
    REQUIRE(std::count(unit.work.convex.begin(), unit.work.convex.end(), 0) > 0);
    smooth_all(unit.work, 10, {});
    CHECK(std::count(unit.work.convex.begin(), unit.work.convex.end(), 0) == 0);
  }

  TEST_CASE("one sweep moves the vertices asked for only") {
    std::mt19937_64 random(8);
    MixedMesh mesh = plain_grid(8, 8);
    perturb(mesh, random, 0.3);
    UnitCase unit(mesh);
    smooth_some(unit.work, {20, 21, 40}, 1, {});
    for (Index v = 0; v < 81; ++v) {
      CAPTURE(v);
      const bool same = same_vertex(unit.work.mesh.vertices[v], mesh.vertices[v]) ||
                        unit.work.mesh.vertices[v].p == mesh.vertices[v].p;
      CHECK(same == (v != 20 && v != 21 && v != 40));
    }
    check_energies(unit.work);
  }

  TEST_CASE("further sweeps reach the neighbours of what has moved") {
    MixedMesh mesh = plain_grid(8, 8);
    mesh.vertices[40].p = {4.3, 3.8};
    mesh.vertices[41].p = {5.2, 4.3};
    UnitCase unit(mesh);
    smooth_some(unit.work, {40}, 30, {.first_step = 0.2, .last_step = 0.005});
    CHECK(displacement(unit.work.mesh, plain_grid(8, 8), Metric{}) < 0.05);  // from 0.36
  }

  TEST_CASE("vertices of very many quadrilaterals are left alone") {
    MixedMesh mesh;
    mesh.vertices.push_back({{0.3, 0}, {}, 0});
    for (int i = 0; i < 34; ++i)
      mesh.vertices.push_back({{std::cos(0.1847995679 * i), std::sin(0.1847995679 * i)}, {}, 0});
    for (Index i = 0; i < 17; ++i)
      mesh.faces.push_back({{0, 1 + 2 * i, 2 + 2 * i, 1 + (2 * i + 2) % 34}});
    add_rim(mesh);
    UnitCase unit(mesh);
    WorkVertex better;
    CHECK_FALSE(QuadSmoother(unit.work).improve(0, {}, better));
    smooth_all(unit.work, 3, {});
    CHECK(unit.work.mesh.vertices[0].p == Point{0.3, 0});
  }
}

TEST_SUITE("property") {
  TEST_CASE("smoothing lowers the energy and never makes a quadrilateral concave") {
    for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
      CAPTURE(seed);
      std::mt19937_64 random(seed);
      const BackgroundMesh background =
          background_of(smooth_random_metric(random, 1, 20, 6), {0, 0}, {6, 6});
      MixedMesh mesh = plain_grid(6, 6);
      perturb(mesh, random, 0.45);
      QuadWork work = work_on(background, mesh);
      const double before = total_energy(work);
      const std::vector<char> convex = work.convex;
      QuadWork again = work;
      smooth_all(work, 6, {});
      CHECK(total_energy(work) < before);
      CHECK(std::count(work.convex.begin(), work.convex.end(), 0) <=
            std::count(convex.begin(), convex.end(), 0));
      check_energies(work);
      smooth_all(again, 6, {});
      CHECK(difference(work, again) == "");  // the same bits
    }
  }
}
