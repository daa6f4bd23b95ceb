#include "adapt/goal_mean.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/adapt/flux_data.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

constexpr double kPi = std::numbers::pi;

Goal patch(Point at, double radius) { return {Goal::Kind::patch_mean, at, radius, 0}; }
Goal region(Index tag) { return {Goal::Kind::region_mean, {}, 0, tag}; }

double mean_over(const FeMesh& mesh, const Goal& goal, const ScalarFunction& f) {
  return mean_of(mesh, goal_mean(mesh, goal), [&](const Element& element, ReferencePoint at) {
    return f(map_at(element, at).x);
  });
}

/// int source f by the rules that the solvers take for sources.
double integral(const FeMesh& mesh, const RegionCoefficient& source, const ScalarFunction& f) {
  double sum = 0;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    const int degree = element.shape == Shape::triangle ? 6 : 7;
    for (const auto& [at, weight, basis] : scalar_rule(element.shape, 2, degree)) {
      const MapPoint map = map_at(element, at);
      sum += weight * map.determinant() * source.in(element.region)(map.x) * f(map.x);
    }
  }
  return sum;
}

std::vector<Mesh> coarse_and_fine_meshes() {
  const auto flat = [](Point p) { return Point{p.x, std::pow(p.y, 4)}; };
  return {square_mesh(1),
          square_quads(2, 2),
          perturbed(mixed_square(7, 7), 7, 7, 0.25, 4),
          perturbed_mesh(40, 0.2, 3),
          mapped(square_mesh(3, 24), flat),
          mapped(square_quads(3, 24), flat)};
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the weight of a patch integrates to a third of its disc on elements of any size") {
    for (const Mesh& mesh : coarse_and_fine_meshes()) {
      const FeMesh fe = straight_fe_mesh(mesh);
      CAPTURE(mesh.points.size());
      for (const double r : {1e-4, 0.01, 0.3}) {
        const double third = kPi * r * r / 3;
        CHECK(goal_mean(fe, patch({0.37, 0.41}, r)).whole == doctest::Approx(third).epsilon(1e-5));
        // Half of it outside, three quarters outside, all within the domain's reach.
        CHECK(goal_mean(fe, patch({0.37, 0}, r)).whole == doctest::Approx(third / 2).epsilon(1e-5));
        CHECK(goal_mean(fe, patch({1, 1}, r)).whole == doctest::Approx(third / 4).epsilon(1e-5));
      }
    }
  }

  TEST_CASE("the patch mean of a quadratic differs from its value by the moment of the weight") {
    // The mean of (x - c)^2 is r^2 / 8: int (1 - s^2)^2 s^3 = 1 / 24, int (1 - s^2)^2 s = 1 / 6.
    const auto quadratic = [](Point p) { return p.x * p.x - 3 * p.y * p.y + p.x * p.y + 2 * p.x; };
    const Point c{0.37, 0.41};
    for (const Mesh& mesh : coarse_and_fine_meshes()) {
      const FeMesh fe = straight_fe_mesh(mesh);
      for (const double r : {0.01, 0.3})
        CHECK(mean_over(fe, patch(c, r), quadratic) ==
              doctest::Approx(quadratic(c) - 2 * r * r / 8).epsilon(1e-5));
    }
  }

  TEST_CASE(
      "sources of a mean give it by the rules of the solvers even in a disc inside an element") {
    const auto quadratic = [](Point p) { return 1 + p.x * p.x - p.x * p.y; };
    for (const Mesh& mesh : coarse_and_fine_meshes()) {
      const FeMesh fe = straight_fe_mesh(mesh);
      CAPTURE(mesh.points.size());
      for (const double r : {1e-3, 0.05, 0.3}) {
        const Goal goal = patch({0.37, 0.41}, r);
        CHECK(integral(fe, mean_source(fe, goal), quadratic) ==
              doctest::Approx(mean_over(fe, goal, quadratic)).epsilon(1e-4));
      }
    }
  }

  TEST_CASE("on bent elements patch and source still agree") {
    const Mesh mesh = square_mesh(3);
    const FeMesh fe = with_bent_bottom(mesh, 0.05);
    const Goal goal = patch({0.5, 0}, 0.02);
    const auto one = [](Point) { return 1.; };
    CHECK(goal_mean(fe, goal).whole == doctest::Approx(kPi * 4e-4 / 3).epsilon(1e-5));
    CHECK(integral(fe, mean_source(fe, goal), one) == doctest::Approx(1).epsilon(1e-6));
  }

  TEST_CASE("the region mean is over the elements with the tag") {
    const Mesh mesh = with_two_regions(mixed_square(6, 4));
    const FeMesh fe = straight_fe_mesh(mesh);
    CHECK(mean_over(fe, region(2), [](Point p) { return p.x; }) == doctest::Approx(0.75));
    // int_{1/2}^1 x^2 / (1/2) = 7/12.
    CHECK(mean_over(fe, region(2), [](Point p) { return p.x * p.x; }) == doctest::Approx(7. / 12));
    const RegionCoefficient source = mean_source(fe, region(2));
    CHECK(source.in(1)({0.1, 0.1}) == 0);
    CHECK(source.in(2)({0.9, 0.1}) == doctest::Approx(2));
  }

  TEST_CASE("the region mean counts the area of bent elements") {
    const Mesh mesh = square_mesh(3);
    CHECK(goal_mean(with_bent_bottom(mesh, 0.06), region(1)).whole == doctest::Approx(1.04));
  }

  TEST_CASE("means over nothing are refused") {
    const Mesh mesh = square_mesh(2);
    const FeMesh fe = straight_fe_mesh(mesh);
    const double inf = std::numeric_limits<double>::infinity();
    for (const double r : {0., -1., inf, std::nan("")})
      CHECK_THROWS_WITH_AS(goal_mean(fe, patch({0.5, 0.5}, r)), doctest::Contains("positive"),
                           InputError);
    CHECK_THROWS_WITH_AS(mean_source(fe, patch({2, 0.5}, 0.9)), doctest::Contains("(2, 0.5)"),
                         InputError);
    CHECK_THROWS_AS(goal_mean(fe, patch({std::nan(""), 0}, 1)), InputError);
    CHECK_THROWS_WITH_AS(goal_mean(fe, region(17)), doctest::Contains("tag 17"), InputError);
  }
}
