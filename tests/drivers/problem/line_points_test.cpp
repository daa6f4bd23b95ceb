#include "drivers/problem/line_points.hpp"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

std::vector<double> shares(Index points, double grading, LineEnd towards = LineEnd::start) {
  return point_shares({.name = "a", .points = points, .grading = grading, .towards = towards});
}

Domain disc() {
  Domain domain;
  domain.curves.push_back({"rim", 1, make_circle({0, 0}, 2)});
  add_region(domain, "disc", 1, {0}, {});
  return domain;
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("points stand in equal steps or by powers towards an end") {
  CHECK(shares(5, 1) == std::vector<double>{0, 0.25, 0.5, 0.75, 1});
  CHECK(shares(5, 2) == std::vector<double>{0, 1. / 16, 4. / 16, 9. / 16, 1});
  CHECK(shares(5, 2, LineEnd::end) == std::vector<double>{0, 7. / 16, 12. / 16, 15. / 16, 1});
  CHECK(shares(5, 2, LineEnd::both) == std::vector<double>{0, 1. / 8, 0.5, 7. / 8, 1});
  CHECK(shares(2, 4, LineEnd::both) == std::vector<double>{0, 1});
  // A layer of a thousandth of the line holds points: (k / 40)^4 < 1/1000 up to k = 7.
  const std::vector<double> fine = shares(41, 4);
  CHECK(fine[7] < 1e-3);
  CHECK(fine[8] > 1e-3);
}

TEST_CASE("graded points of a straight line rise from its start to its very end") {
  for (const LineEnd towards : {LineEnd::start, LineEnd::end, LineEnd::both}) {
    const LineRequest request{.name = "a",
                              .from = {0.1, 0.7},
                              .to = {0.3, 0.1},
                              .points = 30,
                              .grading = 3.7,
                              .towards = towards};
    const LinePoints line = line_points(request, disc());
    REQUIRE(line.points.size() == 30);
    CHECK(line.points.front() == request.from);
    CHECK(line.points.back() == request.to);
    CHECK(line.lengths.front() == 0);
    CHECK(line.lengths.back() == doctest::Approx(std::hypot(0.2, 0.6)));
    for (std::size_t i = 1; i < 30; ++i) {
      CHECK(line.lengths[i] > line.lengths[i - 1]);
      CHECK(norm(line.points[i] - request.from) == doctest::Approx(line.lengths[i]));
    }
  }
}

TEST_CASE("graded points of a curve stand at lengths along it") {
  const LinePoints line =
      line_points({.name = "a", .curve = "rim", .points = 9, .grading = 2}, disc());
  for (std::size_t i = 0; i < 9; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i * i) / 64;
    CHECK(line.lengths[i] == doctest::Approx(2 * angle));
    CHECK(norm(line.points[i] - Point{2 * std::cos(angle), 2 * std::sin(angle)}) < 1e-9);
    CHECK(norm(line.tangents[i] - Vector{-std::sin(angle), std::cos(angle)}) < 1e-9);
  }
}

TEST_CASE("a line on a curve that is not there is refused with the nearest name") {
  const LineRequest request{.name = "a", .curve = "rin", .place = "s.toml:1:2: output.lines[0]"};
  CHECK(has(message_of<UsageError>([&] { line_points(request, disc()); }),
            "output.lines[0].curve: no curve is called \"rin\"; did you mean \"rim\"?"));
}

TEST_SUITE_END();
