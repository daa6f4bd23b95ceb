#include "drivers/base/remaining_time.hpp"

#include <doctest/doctest.h>

using namespace anisofront;

TEST_SUITE_BEGIN("unit");

TEST_CASE("nothing is known before any work is done") {
  RemainingTime time;
  CHECK_FALSE(time.seconds_left(5));
  time.update(3, 0);
  CHECK_FALSE(time.seconds_left(5));
}

TEST_CASE("steady work ends when it should and time runs between updates") {
  RemainingTime time;
  for (int second = 1; second <= 60; ++second) {
    time.update(second, second / 100.);
    CHECK(*time.seconds_left(second) == doctest::Approx(100 - second));
  }
  CHECK(*time.seconds_left(75) == doctest::Approx(25));
  CHECK(*time.seconds_left(300) == 0);  // overdue
}

TEST_CASE("an estimate does not jump and yet follows the work") {
  RemainingTime time;
  time.update(1, 0.1);  // 10 s in all, it seems; from now on a tenth of that speed
  double last = *time.seconds_left(1);
  for (double now = 1.1; now < 40; now += 0.1) {
    time.update(now, 0.1 + 0.01 * (now - 1));
    const double left = *time.seconds_left(now);
    CHECK(left < last + 3);
    last = left;
  }
  // At 40 s 49 % are done: 42 s more at the average speed so far.
  CHECK(last == doctest::Approx(42).epsilon(0.15));
}

TEST_SUITE_END();
