#include "drivers/problem/prescribed_metric.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

const std::string kHead = R"(
[domain]
curves.outer = { polyline = [[0,0],[10,0],[10,10],[0,10],[0,0]] }
curves.hole = { circle = { centre = [5,5], radius = 2 } }
regions.plate = { boundary = ["outer"], holes = [["hole"]] }
[mesh]
initial_size = 1
)";

MetricFunction metric(const std::string& text, MetricLimits limits = {}) {
  const Study study = parse_study(toml::parse(kHead + text), "s.toml");
  return prescribed_metric(*study.metric, study.domain, limits);
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("h1 lies along e1 and h2 across") {
  const Metric along_x = metric("[metric]\nprescribed = [{ h1 = 0.5, h2 = 2 }]")({1, 1});
  CHECK(along_x.m11 == doctest::Approx(4));
  CHECK(along_x.m22 == doctest::Approx(0.25));
  const Metric turned =
      metric("[metric]\nprescribed = [{ h1 = 0.5, h2 = 2, e1 = [\"0\", \"3\"] }]")({1, 1});
  CHECK(turned.m11 == doctest::Approx(0.25));
  CHECK(turned.m22 == doctest::Approx(4));
}

TEST_CASE("a direction that vanishes counts as the x axis") {
  const Metric m =
      metric("[metric]\nprescribed = [{ h1 = 0.5, h2 = 2, e1 = [\"x\", \"y\"] }]")({0, 0});
  CHECK(m.m11 == doctest::Approx(4));
}

TEST_CASE("the list is intersected") {
  const Metric m =
      metric("[metric]\nprescribed = [{ h1 = 1, h2 = 0.1 }, { h1 = 0.5, h2 = 3 }]")({1, 1});
  CHECK(m.m11 == doctest::Approx(4));    // the smaller size along x is 0.5
  CHECK(m.m22 == doctest::Approx(100));  // and along y 0.1
}

TEST_CASE("distance tangent and curvature of the nearest curve are known") {
  const auto f = metric(
      "[metric]\nconstants = { a = 3 }\nwhere = { half = \"a*d/2\" }\n"
      "prescribed = [{ h1 = \"half\", h2 = \"c\", e1 = [\"tx\",\"ty\"], distance_to = [\"hole\"] "
      "}]");
  // (9, 5) lies 2 to the right of the circle of radius 2: tangent along y, h1 = 3, h2 = 1/2.
  const Metric m = f({9, 5});
  CHECK(m.m22 == doctest::Approx(1. / 9));
  CHECK(m.m11 == doctest::Approx(4));
}

TEST_CASE("the metric of the paper's Example 1 has the sizes of Eqn 30") {
  const auto f = metric(
      "[metric]\nprescribed = [{ where = { r = \"abs(x-y)/sqrt(2)\" }, h1 = \"0.05+0.15*r\", "
      "h2 = \"15*h1*exp(-0.55*r)\", e1 = [\"-1\",\"1\"] }]");
  const Metric on_diagonal = f({3, 3});  // h1 = 0.05 across, h2 = 0.75 along
  const double s = std::sqrt(0.5);
  CHECK(length(on_diagonal, {0.05 * s, -0.05 * s}) == doctest::Approx(1));
  CHECK(length(on_diagonal, {0.75 * s, 0.75 * s}) == doctest::Approx(1));
}

TEST_CASE("limits and the isotropic mode change the sizes") {
  MetricLimits limits;
  limits.hmin = 0.2;
  limits.hmax = 1;
  const Metric m = metric("[metric]\nprescribed = [{ h1 = 0.01, h2 = 5 }]", limits)({1, 1});
  CHECK(m.m11 == doctest::Approx(25));
  CHECK(m.m22 == doctest::Approx(1));
  const Metric round = metric(
      "[metric]\nprescribed = [{ h1 = 0.5, h2 = 5 }]\n[adapt]\nmode = \"isotropic\"")({1, 1});
  CHECK(round.m11 == doctest::Approx(4));
  CHECK(round.m22 == doctest::Approx(4));
}

TEST_CASE("bad sizes and unknown names are reported") {
  const auto f = metric("[metric]\nprescribed = [{ h1 = \"x - 5\", h2 = \"1\" }]");
  const std::string message = message_of<InputError>([&] { f({3, 1}); });
  CHECK(has(message, "metric.prescribed[0].h1 = \"x - 5\" is -2 at (x, y) = (3, 1)"));
  CHECK(has(message, "positive and finite"));
  CHECK(
      has(message_of<UsageError>([] { metric("[metric]\nprescribed = [{ h1 = \"d\", h2 = 1 }]"); }),
          "distance_to"));
  CHECK(has(message_of<UsageError>([] {
              metric("[metric]\nprescribed = [{ h1 = \"d\", h2 = 1, distance_to = [\"hol\"] }]");
            }),
            "did you mean \"hole\"?"));
}

TEST_SUITE_END();
