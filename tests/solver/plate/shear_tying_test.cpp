#include "solver/plate/shear_tying.hpp"

#include <functional>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

using Field = std::function<Vector(ReferencePoint)>;

std::vector<double> tied(const std::vector<TieSample>& samples, const Field& field) {
  std::vector<double> ties;
  for (const TieSample& s : samples) {
    if (s.tie >= static_cast<int>(ties.size())) ties.resize(s.tie + 1);
    ties[s.tie] += dot(s.direction, field(s.at));
  }
  return ties;
}

/// Gauss weights on an edge are one half each.
double circulation(Shape shape, const Field& field) {
  double sum = 0;
  for (const double tie : tied(edge_ties(shape), field)) sum += 0.5 * tie;
  return sum;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("edge ties give the circulation up to third degree") {
    const auto turning = [](ReferencePoint p) { return Vector{-p.eta, p.xi}; };  // curl 2
    CHECK(circulation(Shape::triangle, turning) == doctest::Approx(1).epsilon(1e-14));
    CHECK(circulation(Shape::quadrilateral, turning) == doctest::Approx(8).epsilon(1e-14));
    const auto cubic = [](ReferencePoint p) {  // curl 3 (xi^2 + eta^2)
      return Vector{-p.eta * p.eta * p.eta, p.xi * p.xi * p.xi};
    };
    CHECK(circulation(Shape::triangle, cubic) == doctest::Approx(0.5).epsilon(1e-14));
    CHECK(circulation(Shape::quadrilateral, cubic) == doctest::Approx(8).epsilon(1e-14));
    const auto gradient = [](ReferencePoint p) { return Vector{2 * p.xi * p.eta, p.xi * p.xi}; };
    CHECK(std::abs(circulation(Shape::triangle, gradient)) < 1e-15);
  }

  TEST_CASE("edge ties sit on the edges and the two of an edge are numbered together") {
    const auto samples = edge_ties(Shape::triangle);
    REQUIRE(samples.size() == 6);
    for (int k = 0; k < 6; ++k) CHECK(samples[k].tie == k);
    for (const int k : {0, 1}) CHECK(samples[k].at.eta == 0);
    for (const int k : {2, 3})
      CHECK(samples[k].at.xi + samples[k].at.eta == doctest::Approx(1).epsilon(1e-15));
    for (const int k : {4, 5}) CHECK(samples[k].at.xi == 0);
    CHECK(samples[0].at.xi == doctest::Approx(0.5 - 0.5 / std::sqrt(3.)).epsilon(1e-14));
    CHECK(edge_ties(Shape::quadrilateral).size() == 8);
  }

  TEST_CASE("mean ties integrate both components") {
    const auto field = [](ReferencePoint p) { return Vector{p.xi * p.xi, p.xi * p.eta + 1}; };
    const auto on_triangle = tied(mean_ties(Shape::triangle, 0), field);
    CHECK(on_triangle[0] == doctest::Approx(1. / 12).epsilon(1e-14));
    CHECK(on_triangle[1] == doctest::Approx(1. / 24 + 0.5).epsilon(1e-14));
    const auto on_square = tied(mean_ties(Shape::quadrilateral, 3), field);
    REQUIRE(on_square.size() == 5);
    CHECK(on_square[3] == doctest::Approx(4. / 3).epsilon(1e-14));
    CHECK(on_square[4] == doctest::Approx(4).epsilon(1e-14));
  }

  TEST_CASE("mean ties follow the edge ties") {
    const auto constant = [](ReferencePoint) { return Vector{2, 3}; };
    const auto ties = tied(edge_and_mean_ties(Shape::quadrilateral), constant);
    REQUIRE(ties.size() == 10);
    CHECK(ties[8] == doctest::Approx(8));
    CHECK(ties[9] == doctest::Approx(12));
  }
}
