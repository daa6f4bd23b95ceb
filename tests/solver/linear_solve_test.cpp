#include "solver/linear_solve.hpp"

#include <limits>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"

using namespace anisofront;

namespace {

LinearSystem system_of(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& rhs) {
  return {matrix.sparseView(), rhs};
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a positive definite system is solved") {
    const Eigen::Matrix3d matrix{{4, 1, 0}, {1, 3, 1}, {0, 1, 2}};
    const Eigen::Vector3d x = solve_positive_definite(system_of(matrix, {6, 10, 8}));
    CHECK((x - Eigen::Vector3d{1, 2, 3}).norm() < 1e-14);
  }

  TEST_CASE("a mechanism is named instead of a result") {
    const Eigen::Matrix3d loose{{1, -1, 0}, {-1, 1, 0}, {0, 0, 1}};
    CHECK_THROWS_WITH_AS(solve_positive_definite(system_of(loose, {1, 1, 1})),
                         doctest::Contains("held by no boundary condition"), MeshingError);
    const Eigen::Matrix3d indefinite{{1, 2, 0}, {2, 1, 0}, {0, 0, 1}};
    CHECK_THROWS_AS(solve_positive_definite(system_of(indefinite, {1, 1, 1})), MeshingError);
  }

  TEST_CASE("a right-hand side that is not finite gives an error and no numbers") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH_AS(
        solve_positive_definite(system_of(Eigen::Matrix3d::Identity(), {nan, 1, 1})),
        doctest::Contains("not finite"), MeshingError);
  }
}
