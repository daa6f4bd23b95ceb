#include "mesher/quads/mixed_quality.hpp"

#include <doctest/doctest.h>

#include "tests/support/mixed_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

TEST_SUITE("unit") {
  TEST_CASE("a quadrilateral with a flat corner is not strictly convex") {
    const auto convex = [](Point moved) {
      return is_strictly_convex(mixed_mesh({{0, 0}, {1, 0}, moved, {0, 1}}, {}), quad(0, 1, 2, 3));
    };
    CHECK(convex({1, 1}));
    CHECK(convex({0.5001, 0.5}));
    CHECK_FALSE(convex({0.5000000000000001, 0.5}));  // one unit in the last place
    CHECK_FALSE(convex({0.5, 0.5}));
    CHECK_FALSE(convex({0.25, 0.25}));
    CHECK_FALSE(convex({-1, -1}));
  }

  TEST_CASE("faces are judged by alpha and beta and the broken ones are counted") {
    // an equilateral triangle, a rhombus of 60 degrees (ERRATA, 16: 0.36) and a flat triangle
    const double h = 0.8660254037844386;
    const MixedMesh mesh = mixed_mesh({{0, 0}, {1, 0}, {0.5, h}, {1.5, h}, {2, 0}}, {});
    CHECK(shape_quality(mesh, triangle(0, 1, 2)) == doctest::Approx(1));
    CHECK(shape_quality(mesh, quad(0, 1, 3, 2)) == doctest::Approx(0.36));
    Shape shape;
    for (const MixedFace& f : {triangle(0, 1, 2), quad(0, 1, 3, 2), triangle(0, 1, 4)})
      shape.add(mesh, f);
    CHECK(shape.broken == 1);
    CHECK(shape.product == doctest::Approx(0.36));
    CHECK(shape.worst == doctest::Approx(0.36));
  }

  TEST_CASE("the combined quality falls by 1/e per unit of mean edge length too much") {
    // Eqn 17: squares of side 2 and 0.5 in the unit metric deviate by 1 and by 0.5.
    MixedMesh mesh = mixed_mesh({{0, 0},
                                 {2, 0},
                                 {2, 2},
                                 {0, 2},
                                 {0.5, 0},
                                 {0.5, 0.5},
                                 {0, 0.5},
                                 {1, 0},
                                 {0.5, 0.8660254037844386}},
                                {});
    for (WorkVertex& v : mesh.vertices) v.r = factor_of(Metric{});
    CHECK(combined_quality(mesh, quad(0, 1, 2, 3)) == doctest::Approx(0.36787944));
    CHECK(combined_quality(mesh, quad(0, 4, 5, 6)) == doctest::Approx(0.60653066));
    CHECK(combined_quality(mesh, triangle(0, 7, 8)) == doctest::Approx(1));
    CHECK(combined_quality(mesh, triangle(8, 7, 0)) < 0);
    Shape shape;
    for (const MixedFace& f : {quad(0, 1, 2, 3), quad(0, 4, 5, 6), triangle(8, 7, 0)})
      shape.add(mesh, f, combined_quality);
    CHECK(shape.broken == 1);
    CHECK(shape.product == doctest::Approx(0.36787944 * 0.60653066));
  }

  TEST_CASE("fewer broken faces come before a larger product") {
    CHECK(is_better({0, 0.6, 0.1}, {0, 0.5, 0.5}));
    CHECK_FALSE(is_better({0, 0.5, 0.5}, {0, 0.5, 0.5}));
    CHECK(is_better({1, 0.1, 0.1}, {2, 0.9, 0.9}));
    CHECK_FALSE(is_better({1, 0.9, 0.9}, {1, 0.1, 0.1}));
    CHECK_FALSE(is_better({1, 0.9, 0.9}, {0, 0.1, 0.1}));
  }
}
