#include "adapt/steering.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"

using namespace anisofront;

namespace {

CycleRecord cycle(int number, Index vertices, std::optional<double> estimate,
                  CycleSeconds seconds = {}) {
  CycleRecord record;
  record.cycle = number;
  record.background.vertices = vertices;
  record.error.estimate = estimate;
  record.seconds = seconds;
  return record;
}

Target target_error(double error) { return {.vertices = {}, .error = error}; }

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("exactly one positive target is accepted") {
  CHECK_NOTHROW(require_one_target({.vertices = 100, .error = {}}));
  CHECK_NOTHROW(require_one_target(target_error(0.1)));
  CHECK_THROWS_AS(require_one_target({}), UsageError);
  CHECK_THROWS_AS(require_one_target({.vertices = 100, .error = 0.1}), UsageError);
  for (const double bad : {0., -1., std::nan(""), HUGE_VAL}) {
    CHECK_THROWS_AS(require_one_target(target_error(bad)), UsageError);
    CHECK_THROWS_AS(require_one_target({.vertices = bad, .error = {}}), UsageError);
  }
}

TEST_CASE("the true error steers where it is known and is always trusted") {
  const SteeringError known =
      steering_error(CycleError{.estimate = 0.2, .relative_energy = 0.3, .effectivity = {}}, 0);
  CHECK(known.relative == 0.3);
  CHECK(known.trusted);
}

TEST_CASE("estimates are trusted from cycle 2 on") {
  const CycleError error{.estimate = 0.2, .relative_energy = {}, .effectivity = {}};
  CHECK(steering_error(error, 1).relative == 0.2);
  CHECK_FALSE(steering_error(error, 0).trusted);
  CHECK_FALSE(steering_error(error, 1).trusted);
  CHECK(steering_error(error, 2).trusted);
  const GoalRecord goal{-4, 0.5};
  CHECK(steering_error(goal, 2).relative == 0.125);
  CHECK_FALSE(steering_error(goal, 1).trusted);
  CHECK(steering_error(goal, 2).trusted);
}

TEST_CASE("a target of vertices is the next number of vertices whatever the error") {
  CHECK(next_vertices({.vertices = 1500, .error = {}}, 1, 20, {0.9, true}) == 1500);
}

TEST_CASE("vertices follow from the order of the elements") {
  // N ~ e^(-2 / order); the error aimed at is 0.95 of the target.
  const Target target = target_error(0.1);
  CHECK(next_vertices(target, 1, 1000, {0.11, true}) ==
        doctest::Approx(1000 * std::pow(0.11 / 0.095, 2)));
  CHECK(next_vertices(target, 2, 1000, {0.11, true}) == doctest::Approx(1000 * 0.11 / 0.095));
  CHECK(next_vertices(target, 1, 1000, {0.095, true}) == doctest::Approx(1000));
  CHECK(next_vertices(target, 1, 1000, {0.08, true}) < 1000);
}

TEST_CASE("vertices change by no more than a factor of two and errors not trusted take none away") {
  const Target target = target_error(0.1);
  CHECK(next_vertices(target, 1, 1000, {9, true}) == doctest::Approx(2000));
  CHECK(next_vertices(target, 1, 1000, {1e-6, true}) == doctest::Approx(500));
  CHECK(next_vertices(target, 1, 1000, {1e-6, false}) == doctest::Approx(1000));
  CHECK(next_vertices(target, 1, 1000, {9, false}) == doctest::Approx(2000));
}

TEST_CASE("a target is reached only by an error that can be trusted") {
  CHECK(target_state({.vertices = 9, .error = {}}, {0, true}) == TargetState::none);
  CHECK(target_state(target_error(0.1), {0.1, true}) == TargetState::reached);
  CHECK(target_state(target_error(0.1), {0.1001, true}) == TargetState::missed);
  CHECK(target_state(target_error(0.1), {0.05, false}) == TargetState::missed);
}

TEST_CASE("nothing stops the loop without rules") {
  CHECK_FALSE(reason_to_stop({}, {cycle(0, 1000000, 0.1, {1e9, 0, 0, 0, 0, 0})}, 1e9));
}

TEST_CASE("a plateau takes two small changes at an equal number of vertices") {
  const StopRules rules{.plateau = 0.05};
  const auto stops = [&](std::vector<CycleRecord> cycles) {
    return reason_to_stop(rules, cycles, 0).has_value();
  };
  CHECK_FALSE(stops({cycle(0, 100, 1.), cycle(1, 100, 1.)}));
  CHECK(stops({cycle(0, 100, 1.), cycle(1, 100, 1.04), cycle(2, 101, 1.)}));
  CHECK_FALSE(stops({cycle(0, 100, 1.), cycle(1, 100, 1.06), cycle(2, 100, 1.06)}));
  CHECK_FALSE(stops({cycle(0, 100, 1.), cycle(1, 100, 1.), cycle(2, 110, 1.)}));
  CHECK_FALSE(stops({cycle(0, 100, {}), cycle(1, 100, 1.), cycle(2, 100, 1.)}));
  const StopReason reason =
      reason_to_stop(rules, {cycle(0, 9, 9.), cycle(1, 9, 1.), cycle(2, 9, 1.), cycle(3, 9, 1.)}, 0)
          .value();
  CHECK(reason.by == StoppedBy::plateau);
  CHECK(reason.words ==
        "plateau after 3 cycles: the estimate changed by less than 5 % in two cycles at 9 "
        "vertices");
}

TEST_CASE("the budget of vertices counts those of the next mesh") {
  const StopRules rules{.max_vertices = 1000};
  CHECK_FALSE(reason_to_stop(rules, {cycle(0, 9999, {})}, 1000));
  const StopReason reason = reason_to_stop(rules, {cycle(4, 9, {})}, 1001).value();
  CHECK(reason.by == StoppedBy::budget);
  CHECK(reason.words ==
        "budget reached after 4 cycles: the next mesh would have about 1001 vertices, 1000 are "
        "allowed");
}

TEST_CASE("the budget of seconds counts all phases of all cycles") {
  const StopRules rules{.max_seconds = 42};
  const CycleSeconds six{1, 2, 3, 4, 5, 6};  // 21 in all
  CHECK_FALSE(reason_to_stop(rules, {cycle(0, 9, {}, six)}, 9));
  const StopReason reason =
      reason_to_stop(rules, {cycle(0, 9, {}, six), cycle(1, 9, {}, six)}, 9).value();
  CHECK(reason.by == StoppedBy::budget);
  CHECK(reason.words == "budget reached after 1 cycles: 42 of 42 seconds are used");
}

TEST_SUITE_END();
