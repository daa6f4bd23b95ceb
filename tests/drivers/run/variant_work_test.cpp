#include "drivers/run/variant_work.hpp"

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

VariantPlan small_plan() {
  VariantPlan plan;
  plan.cycles = 3;
  plan.first_vertices = 100;
  plan.vertices = 1000;
  plan.mesh_work = 1;
  plan.solve_work = 2;
  return plan;
}

/// Work of cycle 0 and of the others: 100 and 1000 vertices, each mesh with an overhead of 1000.
constexpr double kFirst = 2 * 100, kLater = 1 * (1000 + 1000) + 2 * 1000;

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("later cycles are expected to be as dear as their meshes are large") {
  VariantWork work(small_plan());
  CHECK(work.total() == doctest::Approx(kFirst + 3 * kLater));
  CHECK(work.done() == 0);
  work.finish_cycle(100, 1000);
  CHECK(work.done() == doctest::Approx(kFirst));
  CHECK(work.total() == doctest::Approx(kFirst + 3 * kLater));
  // The next mesh turns out to be twice as large, and so will those after it.
  work.finish_cycle(1000, 2000);
  CHECK(work.total() == doctest::Approx(kFirst + kLater + 2 * (3000 + 4000)));
  CHECK(work.stage() == "cycle 2 of 3");
}

TEST_CASE("a target for the error lets meshes grow in each cycle") {
  VariantPlan plan = small_plan();
  plan.growth = 2;
  CHECK(VariantWork(plan).total() ==
        doctest::Approx(kFirst + kLater + (3000 + 4000) + (5000 + 8000)));
}

TEST_CASE("work within a cycle never counts back nor beyond the cycle") {
  VariantWork work(small_plan());
  work.finish_cycle(100, 1000);
  double last = work.done();
  const std::pair<const char*, double> reports[] = {
      {"cycles", 0},    {"front", 0.5},         {"front", 1},         {"enhance", 0},
      {"enhance", 0.9}, {"front", 0},           {"linear system", 0}, {"linear system", 1},
      {"quads", 1},     {"something else", 0.5}};
  for (const auto& [phase, fraction] : reports) {
    work.report(phase, fraction);
    CHECK(work.done() >= last);
    CHECK(work.done() <= kFirst + kLater);
    last = work.done();
  }
  CHECK(last > kFirst + 0.8 * kLater);
}

TEST_CASE("a variant that ends early has no work left") {
  VariantWork work(small_plan());
  work.finish_cycle(100, 1000);
  work.report("front", 1);
  work.finish();
  CHECK(work.done() == doctest::Approx(kFirst));
  CHECK(work.total() == work.done());
}

TEST_CASE("cycles of an earlier run are only analysed again") {
  VariantPlan plan = small_plan();
  plan.done_vertices = {100, 1000};
  VariantWork work(plan);
  const double again = 2 * (100 + 1000);
  CHECK(work.total() == doctest::Approx(again + 2 * kLater));
  work.report("resume", 0.5);
  work.report("linear system", 1);
  CHECK(work.done() == doctest::Approx(again / 2));
  CHECK(work.stage() == "earlier cycles");
  work.report("cycles", 0.3);
  CHECK(work.done() == doctest::Approx(again));
  CHECK(work.stage() == "cycle 2 of 3");
  CHECK(work.total() == doctest::Approx(again + 2 * kLater));
}

TEST_CASE("the reference solution is work too") {
  VariantPlan plan = small_plan();
  plan.cycles = 0;
  plan.reference_vertices = 500;
  VariantWork work(plan);
  CHECK(work.total() == doctest::Approx(kFirst + 500 * (1 + 2 * 2)));
  work.finish_cycle(100, 0);
  work.report("reference", 1);
  CHECK(work.stage() == "true errors");
  CHECK(work.done() == doctest::Approx(kFirst));
  work.report("enhance", 1);
  CHECK(work.done() == doctest::Approx(kFirst + 500));
  work.report("linear system", 1);
  CHECK(work.done() > kFirst + 500 * (1 + 2));
  CHECK(work.done() < work.total());
}

TEST_SUITE_END();
