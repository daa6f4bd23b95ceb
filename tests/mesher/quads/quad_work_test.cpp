#include "mesher/quads/quad_work.hpp"

#include <doctest/doctest.h>

#include "tests/mesher/quads/quad_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Everything scaled by the factor.
MixedMesh enlarged(MixedMesh mesh, double factor) {
  for (WorkVertex& v : mesh.vertices) v.p = factor * v.p;
  return mesh;
}

MixedMesh one_quad(double width, double height) {
  MixedMesh mesh = plain_grid(1, 1);
  for (WorkVertex& v : mesh.vertices) v.p = {width * v.p.x, height * v.p.y};
  return mesh;
}

/// What the numbers below are for, whatever the defaults.
constexpr QuadWeights kWeights{.shape2 = 0, .length = 0.4, .potential = 0.2};

double energy_of_one(double width, double height, const QuadWeights& weights = kWeights) {
  const BackgroundMesh background =
      background_of([](Point) { return Metric{}; }, {0, 0}, {width, height});
  return work_on(background, one_quad(width, height), weights).energy[0];
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("unit squares have no energy") {
    const UnitCase unit(l_shape());
    for (const double energy : unit.work.energy) CHECK(energy == doctest::Approx(0).epsilon(1e-12));
    for (const char convex : unit.work.convex) CHECK(convex);
    CHECK(unit.work.beta_of(0) == doctest::Approx(1).epsilon(1e-12));
  }

  TEST_CASE("so have metric unit squares in any constant metric") {
    const double h1 = 0.02, h2 = 1, phi = 0.5;
    const Vector e1{std::cos(phi), std::sin(phi)}, e2{-e1.y, e1.x};
    MixedMesh mesh = plain_grid(4, 3);
    for (WorkVertex& v : mesh.vertices) v.p = h1 * v.p.x * e1 + h2 * v.p.y * e2;
    const BackgroundMesh background =
        background_of([&](Point) { return metric_from_sizes(h1, h2, e1); }, {-3, -3}, {3, 3});
    const QuadWork work = work_on(background, mesh);
    for (const double energy : work.energy) CHECK(energy == doctest::Approx(0).epsilon(1e-9));
  }

  TEST_CASE("an edge of length sqrt 2 costs the weight of two a quarter each side") {
    const double sqrt2 = std::sqrt(2.);
    // Sides on the boundary have no other quadrilateral and count twice: 2 * 0.4 / 4 * (2 + 2).
    CHECK(energy_of_one(sqrt2, 1) == doctest::Approx(0.8).epsilon(0.02));
    CHECK(energy_of_one(1 / sqrt2, 1) == doctest::Approx(0.8).epsilon(0.02));
    QuadWeights heavy = kWeights;
    heavy.length = 4;
    CHECK(energy_of_one(sqrt2, 1, heavy) == doctest::Approx(8).epsilon(0.02));
    UnitCase unit(enlarged(plain_grid(3, 3), sqrt2), kWeights);
    CHECK(unit.work.energy[4] == doctest::Approx(0.1 * 4 * 2).epsilon(0.02));
    CHECK(unit.work.energy[0] == doctest::Approx(0.1 * (2 + 2 * 2) * 2).epsilon(0.02));
    CHECK(unit.work.energy[1] == doctest::Approx(0.1 * (3 + 2) * 2).epsilon(0.02));
  }

  TEST_CASE("only lengths by Simpson's rule see a layer that is crossed mid-edge") {
    const auto layer = [](Point p) {
      return metric_from_size(1 - 0.75 * std::max(0., 1 - 4 * std::fabs(p.y - 0.5)));
    };
    const BackgroundMesh background = background_of(layer, {0, 0}, {1, 1});
    QuadWeights weights;
    CHECK(work_on(background, one_quad(1, 1), weights).energy[0] ==
          doctest::Approx(0).epsilon(1e-12));
    weights.middle_lengths = true;
    // The length (1 + 4 / 0.25 + 1) / 6 = 3 of two sides: z = 3.17.
    const QuadWork work = work_on(background, one_quad(1, 1), weights);
    CHECK(work.edge_defect(work.mesh.vertices[0], work.mesh.vertices[2]) > 100);
    CHECK(work.edge_defect(work.mesh.vertices[0], work.mesh.vertices[2]) ==
          doctest::Approx(length_defect(9, 9)).epsilon(1e-9));
    CHECK(work.edge_defect(work.mesh.vertices[0], work.mesh.vertices[1]) ==
          doctest::Approx(0).epsilon(1e-12));
  }

  TEST_CASE("the ideal valence is the number of right angles that fit") {
    const UnitCase l(l_shape());
    CHECK(l.work.ideal[0] == 1);
    CHECK(l.work.ideal[3] == 2);
    CHECK(l.work.ideal[24] == 3);
    CHECK(l.work.ideal[8] == 4);
    const UnitCase ring(annulus());
    CHECK(ring.work.ideal[16] == 3);  // a corner of the hole
    CHECK(ring.work.ideal[17] == 2);
    const UnitCase crack(grid_with_path(6, 6, {3, 10, 17, 24}));
    CHECK(crack.work.ideal[24] == 4);  // the tip
    CHECK(crack.work.ideal[17] == 2);
    CHECK(crack.work.ideal[3] == 1);
    CHECK(crack.work.ideal[49] + crack.work.ideal[50] + crack.work.ideal[51] == 1 + 2 + 2);
  }

  TEST_CASE("the right angles are those of the metric") {
    // Sizes four times as large along the diagonal: there the corners have 152 degrees, else 28.
    const BackgroundMesh background = background_of(
        [](Point) {
          return metric_from_sizes(1, 4, {1, -1});
        },
        {0, 0}, {1, 1});
    const QuadWork work = work_on(background, one_quad(1, 1));
    CHECK(work.ideal == std::vector<std::uint8_t>{2, 1, 1, 2});
    const BackgroundMesh other = background_of(
        [](Point) {
          return metric_from_sizes(1, 4, {1, 1});
        },
        {0, 0}, {1, 1});
    CHECK(work_on(other, one_quad(1, 1)).ideal == std::vector<std::uint8_t>{1, 2, 2, 1});
  }

  TEST_CASE("the change of energy is that of all touched quadrilaterals with the potential") {
    UnitCase unit(plain_grid(4, 4), kWeights);
    QuadWork& work = unit.work;
    const QuadWork before = work;
    WorkVertex moved = work.mesh.vertices[12];
    moved.p = moved.p + Vector{0.2, 0.1};
    work.begin();
    work.move(12, moved);
    int not_convex = 7;
    const double change = work.energy_change(not_convex);
    CHECK(not_convex == 0);
    CHECK(change > 0.01);
    CHECK(change == doctest::Approx(total_energy(work) - total_energy(before)).epsilon(1e-12));
    CHECK(work.energy_change(not_convex) == change);  // again: the same
    CHECK(work.valence_growth() == 0);
    CHECK(difference(work, before) != "");
    work.undo();
    CHECK(difference(work, before) == "");
    REQUIRE(collapse_diagonal(work, 40));  // one quadrilateral less: its potential is gained back
    const double collapsed = work.energy_change(not_convex);
    CHECK(collapsed == doctest::Approx(total_energy(work) - total_energy(before)).epsilon(1e-12));
  }

  TEST_CASE("quadrilaterals that become convex or cease to be are counted") {
    UnitCase unit(plain_grid(2, 2));
    QuadWork& work = unit.work;
    WorkVertex moved = work.mesh.vertices[4];
    moved.p = {1.9, 1.9};  // beyond the diagonal of the upper right square
    int not_convex = 0;
    work.begin();
    work.move(4, moved);
    CHECK(work.energy_change(not_convex) > 39);
    CHECK(not_convex == 1);
    CHECK_FALSE(work.convex[3]);
    CHECK(work.beta_of(3) <= 0);
    work.commit();
    moved.p = {1, 1};
    work.begin();
    work.move(4, moved);
    CHECK(work.energy_change(not_convex) < -39);
    CHECK(not_convex == -1);
    CHECK(work.convex[3]);
  }

  TEST_CASE("long edges of a convex quadrilateral do not make it count as concave") {
    UnitCase unit(enlarged(plain_grid(2, 2), 5));
    QuadWork& work = unit.work;
    CHECK(work.energy[0] > 39);
    int not_convex = 0;
    WorkVertex moved = work.mesh.vertices[4];
    moved.p = {9.5, 9.5};
    work.begin();
    work.move(4, moved);
    work.energy_change(not_convex);
    CHECK(not_convex == 1);
  }

  TEST_CASE("edges of no length are finite bad") {
    MixedMesh mesh = plain_grid(3, 3);
    mesh.vertices[5].p = mesh.vertices[6].p;
    UnitCase unit(mesh);
    QuadWork& work = unit.work;
    int not_convex = 0;
    for (const bool repair : {false, true}) {
      WorkVertex moved = work.mesh.vertices[5];
      moved.p = repair ? Point{1, 1} : work.mesh.vertices[9].p;
      work.begin();
      work.move(5, moved);
      CHECK(std::isfinite(work.energy_change(not_convex)));
      work.commit();
    }
    CHECK(total_energy(work) == doctest::Approx(-9 * work.weights.potential).epsilon(1e-12));
  }

  TEST_CASE("the free vertices of touched quadrilaterals come ascending and once") {
    MixedMesh grid = plain_grid(4, 4);
    grid.required[13] = 1;
    UnitCase unit(grid);
    QuadWork& work = unit.work;
    work.begin();
    CHECK(work.free_vertices().empty());
    work.move(12, work.mesh.vertices[12]);
    CHECK(work.free_vertices() == std::vector<Index>{6, 7, 8, 11, 12, 16, 17, 18});
    work.undo();
    work.begin();
    work.move(6, work.mesh.vertices[6]);
    CHECK(work.free_vertices() == std::vector<Index>{6, 7, 11, 12});
  }

  TEST_CASE("a commit marks the corners of what was touched") {
    UnitCase unit(plain_grid(4, 4));
    QuadWork& work = unit.work;
    const std::uint32_t first = work.commits();
    work.begin();
    work.move(6, work.mesh.vertices[6]);
    work.undo();
    CHECK(work.commits() == first);
    work.begin();
    work.move(6, work.mesh.vertices[6]);
    work.commit();
    CHECK(work.commits() == first + 1);
    for (Index v = 0; v < 25; ++v) {
      CAPTURE(v);
      CHECK(work.changed_at[v] == (v % 5 <= 2 && v / 5 <= 2 ? first + 1 : first));
    }
  }

  TEST_CASE("a transaction begins where the last one ended") {
    UnitCase unit(plain_grid(4, 4));
    QuadWork& work = unit.work;
    REQUIRE(split_vertex(work, work.mesh.leaving[12], 2));
    work.commit();
    const QuadWork before = work;
    REQUIRE(split_vertex(work, work.mesh.leaving[8], 2));
    work.undo();
    CHECK(difference(work, before) == "");
  }

  TEST_CASE("changed weights count once all energies are updated") {
    UnitCase unit(enlarged(plain_grid(3, 3), 1.2));
    QuadWork& work = unit.work;
    const double before = work.energy[4];
    work.weights.length *= 2;
    CHECK(work.energy[4] == before);
    work.update_all_energies();
    CHECK(work.energy[4] == doctest::Approx(2 * before).epsilon(1e-12));
  }
}
