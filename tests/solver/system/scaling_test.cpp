#include "solver/system/scaling.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/system/sample_systems.hpp"

using namespace anisofront;

TEST_SUITE("unit") {
  TEST_CASE("scaled diagonals lie between a half and two and the factors are powers of two") {
    Eigen::VectorXd diagonal(7);
    diagonal << 1, 3, -5, 1e-300, 1e300, 0.7, 1234.5;
    const SparseMatrix matrix = Eigen::MatrixXd(diagonal.asDiagonal()).sparseView(0, 0);
    const Eigen::VectorXd scale = symmetric_scaling(matrix);
    for (int i = 0; i < 7; ++i) {
      int exponent = 0;
      CHECK(std::frexp(scale[i], &exponent) == 0.5);
      const double scaled = std::abs(scale[i] * diagonal[i] * scale[i]);
      CHECK(scaled >= 0.5);
      CHECK(scaled <= 2);
    }
  }

  TEST_CASE("a zero on the diagonal is not scaled") {
    const Eigen::Matrix2d matrix{{0, 1}, {1, 16}};
    CHECK(symmetric_scaling(matrix.sparseView()) == Eigen::Vector2d{1, 0.25});
  }

  TEST_CASE("a diagonal that is not finite is refused with the unknown") {
    const Eigen::Matrix2d matrix{{1, 0}, {0, HUGE_VAL}};
    CHECK_THROWS_WITH_AS(symmetric_scaling(matrix.sparseView()), doctest::Contains("unknown 1 "),
                         MeshingError);
  }

  TEST_CASE("the scaled norm is the largest column sum") {
    const Eigen::Matrix2d matrix{{4, -2}, {-2, 1}};
    CHECK(scaled_norm(matrix.sparseView(), Eigen::Vector2d{0.5, 1}) == 2);
    CHECK(scaled_norm(matrix.sparseView(), Eigen::Vector2d{1, 1}) == 6);
  }
}
