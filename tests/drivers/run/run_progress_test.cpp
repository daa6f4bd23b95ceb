#include "drivers/run/run_progress.hpp"

#include <sstream>
#include <thread>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

VariantPlan plan_of(double vertices) {
  VariantPlan plan;
  plan.cycles = 2;
  plan.first_vertices = 100;
  plan.vertices = vertices;
  return plan;
}

struct Watched {
  std::ostringstream out, err;
  Console console{out, err};
  RunProgress progress{console};
};

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("the first variant that is not finished speaks for all") {
  Watched run;
  run.progress.plan("a", plan_of(1000));
  run.progress.plan("b", plan_of(1000));
  CHECK(run.progress.state().label == "1 of 2: cycle 0 of 2  a");
  run.progress.finish_cycle("a", 100, 1000);
  run.progress.report("a", "cycles", 0);
  CHECK(run.progress.state().label == "1 of 2: cycle 1 of 2  a");
  run.progress.report("b", "front", 0.5);
  run.progress.report("a", "front", 0.5);
  CHECK(run.progress.state().label == "1 of 2: cycle 1 of 2, front  a");
  run.progress.finish("a");
  CHECK(run.progress.state().label == "2 of 2: cycle 0 of 2, front  b");
  run.progress.finish("b");
  CHECK(run.progress.state().fraction == doctest::Approx(1));
}

TEST_CASE("a study without variants names none") {
  Watched run;
  run.progress.report("main", "front", 0.5);  // the initial mesh, before anything is planned
  run.progress.plan("main", plan_of(1000));
  run.progress.report("main", "enhance", 0.5);
  CHECK(run.progress.state().label == "cycle 0 of 2, enhance");
}

TEST_CASE("the bar never shrinks when work turns out to be more") {
  Watched run;
  run.progress.plan("a", plan_of(1000));
  run.progress.finish_cycle("a", 100, 1000);
  run.progress.finish_cycle("a", 1000, 1000);
  const double before = run.progress.state().fraction;
  CHECK(before > 0.3);
  run.progress.plan("b", plan_of(100000));
  CHECK(run.progress.state().fraction == before);
}

TEST_CASE("the time left is told from the first cycle that has made a mesh") {
  Watched run;
  run.progress.plan("a", plan_of(1000));
  const auto start = std::chrono::steady_clock::now();
  run.progress.finish_cycle("a", 100, 1000);
  std::this_thread::sleep_for(std::chrono::milliseconds(1050));
  CHECK_FALSE(run.progress.state().seconds_left);
  run.progress.finish_cycle("a", 1000, 1000);
  const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - start;
  // As much again is to be done, but for the small first cycle.
  REQUIRE(run.progress.state().seconds_left);
  CHECK(*run.progress.state().seconds_left == doctest::Approx(gone.count()).epsilon(0.1));
}

TEST_CASE("variants side by side may report at the same time") {
  Watched run;
  for (const char* name : {"a", "b", "c"}) run.progress.plan(name, plan_of(1000));
  {
    std::vector<std::jthread> threads;
    for (const std::string name : {"a", "b", "c"})
      threads.emplace_back([&run, name] {
        run.progress.finish_cycle(name, 100, 1000);
        for (int i = 0; i <= 1000; ++i) run.progress.report(name, "front", i / 1000.);
        run.progress.finish_cycle(name, 1000, 1000);
        run.progress.finish_cycle(name, 1000, 1000);
        run.progress.finish(name);
      });
  }
  CHECK(run.progress.state().fraction == doctest::Approx(1));
}

TEST_SUITE_END();
