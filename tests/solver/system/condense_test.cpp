#include "solver/system/condense.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"

using namespace anisofront;

TEST_SUITE("unit") {
  TEST_CASE("eliminating inner unknowns leaves the solution of the outer ones as it was") {
    const Eigen::Matrix4d a{{5, 1, 2, 0}, {1, 6, -1, 1}, {3, 1, 7, 2}, {0, 1, 2, 8}};
    const Eigen::Vector4d b{1, 2, 3, 4}, x = a.lu().solve(b);
    ElementSystem system{a, b};
    condense({}, 2, system);
    const Eigen::Matrix2d reduced = system.matrix.topLeftCorner(2, 2);
    const Eigen::Vector2d outer = reduced.lu().solve(Eigen::Vector2d(system.rhs.head(2)));
    CHECK((outer - x.head(2)).norm() < 1e-14);
    LocalValues values(4);
    values << outer, 0, 0;
    expand(2, system, values);
    CHECK((values - x).norm() < 1e-14);
  }

  TEST_CASE("an element whose inner unknowns are free is named") {
    ElementSystem system;
    system.set_zero(3);
    Element element;
    element.number = 41;
    CHECK_THROWS_WITH_AS(condense(element, 2, system), doctest::Contains("element 42"),
                         MeshingError);
  }
}
