#include "solver/system/extended_residual.hpp"

#include <doctest/doctest.h>

#include "tests/solver/system/sample_systems.hpp"

using namespace anisofront;

__extension__ typedef __float128 Quadruple;

TEST_SUITE("unit") {
  TEST_CASE("a residual that cancels to the last bit of the products is exact") {
    // (1 + 2^-30)^2 = 1 + 2^-29 + 2^-60: the last term does not fit into a double
    const double a = 1 + std::ldexp(1, -30);
    const Eigen::Matrix<double, 1, 1> matrix{a};
    ExtendedVector x(1);
    x.add(Eigen::VectorXd::Constant(1, a));
    const Eigen::VectorXd b = Eigen::VectorXd::Constant(1, 1 + std::ldexp(1, -29));
    CHECK(extended_residual(matrix.sparseView(), b, x)[0] == -std::ldexp(1, -60));
  }

  TEST_CASE("large terms of opposite sign leave the small one") {
    const Eigen::Matrix3d matrix{{1e20, 1, -1e20}, {0, 1, 0}, {0, 0, 1}};
    ExtendedVector x(3);
    x.add(Eigen::Vector3d{1, 3, 1});
    const SparseMatrix rows = matrix.transpose().sparseView();
    CHECK(extended_residual(rows, Eigen::Vector3d::Zero(), x) == Eigen::Vector3d{-3, -3, -1});
  }

  TEST_CASE("steps far below the last digit of a vector are kept") {
    ExtendedVector x(1);
    x.add(Eigen::VectorXd::Constant(1, 1.));
    for (int k = 0; k < 1000; ++k) x.add(Eigen::VectorXd::Constant(1, 1e-20));
    CHECK(x.high[0] == 1);
    CHECK(x.low[0] == doctest::Approx(1e-17).epsilon(1e-12));
  }

  TEST_CASE("the residual is that of quadruple precision to a last digit") {
    const int n = 40;
    const Eigen::MatrixXd matrix = random_unsymmetric(n, 4);
    const Eigen::VectorXd value = sample_load(n) / 7, step = sample_load(n) * 1e-18;
    ExtendedVector x(n);
    x.add(value);
    x.add(step);
    const Eigen::VectorXd b = matrix * value;
    const SparseMatrix rows = matrix.transpose().sparseView();
    const Eigen::VectorXd residual = extended_residual(rows, b, x);
    for (int i = 0; i < n; ++i) {
      Quadruple sum = b[i];
      for (int j = 0; j < n; ++j) sum -= Quadruple(matrix(i, j)) * (Quadruple(value[j]) + step[j]);
      CHECK(residual[i] == doctest::Approx(static_cast<double>(sum)).epsilon(1e-13));
    }
  }
}
