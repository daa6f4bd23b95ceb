#include "mesher/quads/quad_clean.hpp"

#include <doctest/doctest.h>

#include "mesher/quads/quad_smooth.hpp"
#include "tests/mesher/quads/quad_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Interior vertices with other than four quadrilaterals.
Index irregular_count(const QuadMesh& mesh) {
  Index count = 0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (mesh.leaving[v] != kNoIndex && mesh.kind[v] == QuadVertexKind::free)
      count += mesh.valence[v] != 4;
  return count;
}

/// Commits random operations on a perturbed mesh.
void make_messy(QuadWork& work, std::mt19937_64& random, int operations) {
  for (int done = 0; done < operations;) {
    if (!apply_random(work, random, static_cast<int>(random() % kOperationKinds))) continue;
    int not_convex = 0;
    work.energy_change(not_convex);
    work.commit();
    ++done;
  }
}

void check_whole(const QuadWork& work, const QuadMesh& before) {
  CHECK(broken_invariant(work.mesh) == "");
  CHECK(rim_of(work.mesh) == rim_of(before));
  CHECK(euler_number(work.mesh) == euler_number(before));
  CHECK(signed_area(work.mesh) == doctest::Approx(signed_area(before)).epsilon(1e-10));
  for (Index q = 0; q < work.mesh.quad_count(); ++q)
    if (!work.mesh.is_dead(q)) CHECK(work.energy[q] == work.energy_of(q).value);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a regular grid is left as it is") {
    UnitCase unit(plain_grid(6, 6));
    const QuadWork before = unit.work;
    const CleanStatistics statistics = clean(unit.work, {});
    CHECK(statistics.trials == 0);
    CHECK(statistics.operations == 0);
    CHECK(difference(unit.work, before) == "");
  }

  TEST_CASE("what one operation did to a regular grid is repaired") {
    struct Damage {
      const char* name;
      bool (*apply)(QuadWork& work, Index h);
      int most_operations;
    };
    const Damage damages[] = {
        {"edge by one step", [](QuadWork& w, Index h) { return rotate_edge(w, h, 1); }, 2},
        {"edge by two steps", [](QuadWork& w, Index h) { return rotate_edge(w, h, 2); }, 2},
        {"split", [](QuadWork& w, Index h) { return split_vertex(w, h, 2); }, 1},
        {"collapse", [](QuadWork& w, Index h) { return collapse_diagonal(w, h); }, 1},
        {"vertex", [](QuadWork& w, Index h) { return rotate_vertex(w, w.mesh.corner[h]); }, 4}};
    for (const Damage& damage : damages) {
      CAPTURE(std::string(damage.name));
      UnitCase unit(plain_grid(8, 8));
      QuadWork& work = unit.work;
      REQUIRE(damage.apply(work, 4 * 36));  // at (4, 4)
      int not_convex = 0;
      work.energy_change(not_convex);
      work.commit();
      const QuadMesh before = work.mesh;
      REQUIRE(irregular_count(before) > 2);
      const CleanStatistics statistics = clean(work, {});
      CHECK(statistics.operations >= 1);
      CHECK(statistics.operations <= damage.most_operations);
      CHECK(irregular_count(work.mesh) == 0);
      CHECK(live_quads(work.mesh) == 64);
      CHECK(count_not_convex(work.mesh) == 0);
      check_whole(work, before);
    }
  }

  TEST_CASE("concave and flat and clockwise quadrilaterals are counted") {
    MixedMesh mesh = plain_grid(2, 2);
    const auto count = [&](Point centre) {
      mesh.vertices[4].p = centre;
      return count_not_convex(make_quad_mesh(mesh));
    };
    CHECK(count({1, 1}) == 0);
    CHECK(count({1.5, 1.5}) == 1);          // exactly on the diagonal
    CHECK(count({1.5 - 1e-15, 1.5}) == 1);  // as good as
    CHECK(count({1.5 - 1e-6, 1.5}) == 0);
    CHECK(count({1.9, 1.9}) == 1);
    CHECK(count({3, 1}) == 2);
    CHECK(count({30, 30}) == 3);
  }

  TEST_CASE("quadrilaterals that are gone do not count") {
    UnitCase unit(plain_grid(3, 3));
    REQUIRE(collapse_diagonal(unit.work, 16));
    unit.work.commit();
    CHECK(count_not_convex(unit.work.mesh) <= 8);
    UnitCase all(plain_grid(2, 2));
    all.work.mesh.vertices[4].p = {30, 30};
    REQUIRE(count_not_convex(all.work.mesh) == 3);
    REQUIRE(collapse_diagonal(all.work, 0));  // 0 swallows the centre
    all.work.commit();
    CHECK(count_not_convex(all.work.mesh) < 3);
  }

  TEST_CASE("the progress is reported and can stop the work") {
    UnitCase unit(plain_grid(6, 6));
    std::vector<double> reported;
    Monitor monitor;
    monitor.progress = [&](std::string_view, double fraction) {
      reported.push_back(fraction);
      return true;
    };
    clean(unit.work, {}, monitor);
    REQUIRE(!reported.empty());
    CHECK(std::is_sorted(reported.begin(), reported.end()));
    CHECK((reported.front() >= 0 && reported.back() <= 1));
    monitor.progress = [](std::string_view, double) { return false; };
    CHECK_THROWS_AS(clean(unit.work, {}, monitor), Interrupted);
  }
}

TEST_SUITE("property") {
  TEST_CASE("messy meshes of every kind get better and stay whole") {
    for (NamedMesh& named : property_meshes())
      for (const unsigned seed : {1u, 2u}) {
        CAPTURE(named.name);
        CAPTURE(seed);
        std::mt19937_64 random(seed);
        const BackgroundMesh background =
            background_of(smooth_random_metric(random, 1, 4, 8), {0, 0}, {6, 6});
        QuadWork work = work_on(background, named.mesh);
        make_messy(work, random, 12);
        const QuadMesh before = work.mesh;
        const double energy = total_energy(work);
        QuadWork smoothed = work;
        smooth_all(smoothed, 20, {.first_step = 0.3, .last_step = 0.01});
        QuadWork again = work;
        const CleanStatistics statistics = clean(work, {});
        CHECK(statistics.operations > 0);
        CHECK(statistics.trials >= statistics.operations);
        CHECK(total_energy(work) < energy);
        CHECK(total_energy(work) < total_energy(smoothed));  // smoothing alone does less
        CHECK(count_not_convex(work.mesh) <= count_not_convex(before));
        check_whole(work, before);
        clean(again, {});
        CHECK(difference(work, again) == "");  // the same bits
      }
  }

  TEST_CASE("no clean-up makes quadrilaterals concave even where the sizes are wrong") {
    for (const double size : {0.15, 0.4, 2.5, 6.})
      for (const unsigned seed : {1u, 2u, 3u}) {
        CAPTURE(size);
        CAPTURE(seed);
        std::mt19937_64 random(seed);
        const BackgroundMesh background =
            background_of(smooth_random_metric(random, size, 8, 6), {0, 0}, {5, 5});
        MixedMesh mesh = plain_grid(5, 5);
        perturb(mesh, random, 0.9);
        QuadWork work = work_on(background, mesh);
        const QuadMesh before = work.mesh;
        clean(work, {.most_passes = 3});
        CHECK(count_not_convex(work.mesh) <= count_not_convex(before));
        check_whole(work, before);
        const QuadMesh cleaned = work.mesh;
        polish(work);
        CHECK(count_not_convex(work.mesh) <= count_not_convex(cleaned));
        check_whole(work, before);
      }
  }

  TEST_CASE("polishing lowers its own energy and keeps the mesh whole") {
    for (const unsigned seed : {1u, 2u, 3u, 4u}) {
      CAPTURE(seed);
      std::mt19937_64 random(seed);
      const BackgroundMesh background =
          background_of(smooth_random_metric(random, 1, 4, 8), {0, 0}, {6, 6});
      QuadWork work = work_on(background, plain_grid(6, 6));
      make_messy(work, random, 12);
      clean(work, {.most_passes = 1});
      QuadWork before = work;
      QuadWork again = work;
      polish(work);
      CHECK(work.weights.middle_lengths);
      before.weights = work.weights;
      CHECK(total_energy(work) <= total_energy(before));
      check_whole(work, before.mesh);
      polish(again);
      CHECK(difference(work, again) == "");
    }
  }
}
