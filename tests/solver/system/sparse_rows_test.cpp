#include "solver/system/sparse_rows.hpp"

#include <doctest/doctest.h>

#include "tests/solver/system/sample_systems.hpp"

using namespace anisofront;

TEST_SUITE("unit") {
  TEST_CASE("products are those of dense matrices") {
    const Eigen::MatrixXd a = random_entries(50, 4, 1), b = random_entries(50, 3, 2).leftCols(20);
    const SparseRows left = a.sparseView(), right = b.sparseView();
    CHECK((Eigen::MatrixXd(product(left, right)) - a * b).norm() < 1e-14);
    const Eigen::VectorXd x = sample_load(20), y = sample_load(50);
    Eigen::VectorXd result;
    multiply(right, x, result);
    CHECK((result - b * x).norm() < 1e-14);
    add_product(right, x, result);
    CHECK((result - 2 * b * x).norm() < 1e-13);
    subtract_product(right, x, y, result);
    CHECK((result - (y - b * x)).norm() < 1e-13);
  }

  TEST_CASE("columns of a product ascend within each row") {
    const SparseRows rows = random_entries(40, 5, 3).sparseView();
    const SparseRows square = product(rows, rows);
    CHECK(square.isCompressed());
    for (Index row = 0; row < 40; ++row) {
      Index last = -1;
      for (SparseRows::InnerIterator entry(square, row); entry; ++entry) {
        CHECK(entry.col() > last);
        last = static_cast<Index>(entry.col());
      }
    }
  }

  TEST_CASE("sums over many blocks are right") {
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(20001, 0, 20000);
    CHECK(inner_product(x, Eigen::VectorXd::Ones(20001)) == 200010000);
    CHECK(inner_product(Eigen::VectorXd(), Eigen::VectorXd()) == 0);
  }
}
