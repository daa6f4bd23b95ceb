#include "solver/system/symbolic.hpp"

#include <Eigen/SparseCholesky>
#include <doctest/doctest.h>

#include "tests/solver/system/sample_systems.hpp"

using namespace anisofront;

TEST_SUITE("unit") {
  TEST_CASE("the factor of an arrow depends on which end comes first") {
    Eigen::MatrixXd arrow = 5 * Eigen::MatrixXd::Identity(5, 5);
    arrow.row(4).setOnes();
    arrow.col(4).setOnes();
    CHECK(factor_nonzeros(arrow.sparseView()) == 9);
    CHECK(factor_nonzeros(arrow.reverse().sparseView()) == 15);
  }

  TEST_CASE("the count is that of the factor itself") {
    for (const unsigned seed : {1u, 2u, 3u, 4u}) {
      const SparseMatrix matrix = random_positive_definite(70, seed).sparseView();
      Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<Index>> factors(
          matrix);
      CHECK(factor_nonzeros(matrix) == double(SparseMatrix(factors.matrixL()).nonZeros()));
    }
  }

  TEST_CASE("unknowns of one node make one run") {
    // a chain of four nodes with 3, 1, 2 and 2 unknowns
    const Eigen::MatrixXd chain{{2, 1, 0, 0}, {1, 2, 1, 0}, {0, 1, 2, 1}, {0, 0, 1, 2}};
    const int node[] = {0, 0, 0, 1, 2, 2, 3, 3};
    Eigen::MatrixXd matrix(8, 8);
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j) matrix(i, j) = chain(node[i], node[j]);
    const CompressedPattern pattern = compressed_pattern(matrix.sparseView());
    CHECK(pattern.first_unknown == std::vector<Index>{0, 3, 4, 6, 8});
    CHECK(pattern.begin == std::vector<std::int64_t>{0, 2, 5, 8, 10});
    CHECK(pattern.neighbours == std::vector<std::int64_t>{0, 1, 0, 1, 2, 1, 2, 3, 2, 3});
    CHECK(unknown_order(pattern, {2, 0, 3, 1}) ==
          std::vector<std::int64_t>{4, 5, 0, 1, 2, 6, 7, 3});
  }
}
