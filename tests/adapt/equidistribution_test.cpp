#include "adapt/equidistribution.hpp"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

double density(const PrincipalMetric& m) { return std::sqrt(m.l1 * m.l2); }

PrincipalField stretched(std::size_t vertices) {
  return PrincipalField(vertices, PrincipalMetric{400, 4, {0.6, 0.8}});
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("equal contributions keep the density of the mesh and the shape of the field") {
    const Mesh mesh = square_mesh(4);  // 32 triangles of 1/32
    PrincipalField field = stretched(mesh.points.size());
    equidistribute(mesh, std::vector<double>(32, 0.7), 1, kNoLimit, field);
    for (const PrincipalMetric& m : field) {
      CHECK(density(m) == doctest::Approx(32));
      CHECK(m.l1 / m.l2 == doctest::Approx(100));
      CHECK(m.e1.x == 0.6);
    }
  }

  TEST_CASE("16 times the contribution asks for 4 times the elements of order 1") {
    const Mesh mesh = square_mesh(2);
    std::vector<double> contributions(8, 1.);
    PrincipalField plain = stretched(9), more = plain, second = plain;
    equidistribute(mesh, contributions, 1, kNoLimit, plain);
    for (double& c : contributions) c = 16;
    contributions[0] = 1;  // the mean differs, so that only ratios count
    equidistribute(mesh, contributions, 1, kNoLimit, more);
    equidistribute(mesh, contributions, 2, kNoLimit, second);
    // A vertex of element 0 alone and one far from it.
    const Index near = 1, far = 8;
    REQUIRE(plain[near].l1 == doctest::Approx(plain[far].l1));
    std::vector<int> around(9, 0), of_first(9, 0);
    for (std::size_t e = 0; e < mesh.triangles.size(); ++e)
      for (const Index v : mesh.triangles[e]) {
        ++around[v];
        of_first[v] += e == 0;
      }
    for (Index v = 0; v < 9; ++v) {
      if (of_first[v] == 0) continue;
      const double share = 1. / around[v];  // of element 0 in the geometric mean
      const bool has_clean = of_first[far] == 0;
      REQUIRE(has_clean);
      CHECK(density(more[far]) / density(more[v]) == doctest::Approx(std::pow(4, share)));
      CHECK(density(second[far]) / density(second[v]) == doctest::Approx(std::pow(16, share / 3)));
    }
  }

  TEST_CASE("shapes are limited to the stretch before the density is set") {
    const Mesh mesh = square_mesh(2);
    PrincipalField field = stretched(9);
    equidistribute(mesh, std::vector<double>(8, 1.), 2, 3, field);
    for (const PrincipalMetric& m : field) {
      CHECK(density(m) == doctest::Approx(8));
      CHECK(m.l1 / m.l2 == doctest::Approx(9));
    }
  }

  TEST_CASE("elements without any error do not vanish and no error at all changes nothing") {
    const Mesh mesh = square_mesh(2);
    std::vector<double> contributions(8, 0.);
    PrincipalField field = stretched(9);
    equidistribute(mesh, contributions, 1, kNoLimit, field);
    CHECK(field[3].l1 == 400);
    contributions[5] = 1;
    equidistribute(mesh, contributions, 1, kNoLimit, field);
    for (const PrincipalMetric& m : field) {
      CHECK(std::isfinite(m.l1));
      CHECK(density(m) > 7.9e-3);  // (1e-6)^(1/2) of the present one
    }
  }

  TEST_CASE("quadrilaterals have contributions too") {
    const Mesh mesh = square_quads(3, 3);
    PrincipalField field = stretched(16);
    equidistribute(mesh, std::vector<double>(9, 2.), 2, kNoLimit, field);
    CHECK(density(field[0]) == doctest::Approx(9));
  }

  TEST_CASE("contributions that are missing or negative or not finite are refused") {
    const Mesh mesh = square_mesh(2);
    PrincipalField field = stretched(9);
    const auto with = [&](double value) {
      std::vector<double> contributions(8, 1.);
      contributions[3] = value;
      equidistribute(mesh, contributions, 1, kNoLimit, field);
    };
    CHECK_THROWS_AS(with(-1), InputError);
    CHECK_THROWS_AS(with(std::nan("")), InputError);
    CHECK_THROWS_AS(equidistribute(mesh, std::vector<double>(7, 1.), 1, kNoLimit, field),
                    InputError);
  }
}
