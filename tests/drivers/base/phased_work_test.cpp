#include "drivers/base/phased_work.hpp"

#include <doctest/doctest.h>

using namespace anisofront;

TEST_SUITE_BEGIN("unit");

TEST_CASE("without a plan every phase counts for itself") {
  PhasedWork work("read");
  const WorkState state = work.report("nodes", 0.7, 1);
  CHECK(state.fraction == 0.7);
  CHECK(state.label == "read: nodes");
  CHECK_FALSE(state.seconds_left);
}

TEST_CASE("planned phases add up and what is repeated does not count back") {
  PhasedWork work("mesh", {{{"front", 0, 0.4}, {"enhance", 0.4, 1}}, true});
  CHECK(work.report("front", 0.5, 2).fraction == doctest::Approx(0.2));
  const WorkState state = work.report("enhance", 0.5, 7);
  CHECK(state.fraction == doctest::Approx(0.7));
  CHECK(*state.seconds_left == doctest::Approx(3));
  CHECK(work.report("front", 0, 7).fraction == doctest::Approx(0.7));
  CHECK(work.report("unheard of", 1, 7).fraction == doctest::Approx(0.7));
}

TEST_CASE("shares that are no times give no time left") {
  PhasedWork work("solve", {{{"linear system", 0.3, 0.9}}, false});
  CHECK_FALSE(work.report("linear system", 1, 7).seconds_left);
}

TEST_SUITE_END();
