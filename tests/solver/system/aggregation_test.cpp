#include "solver/system/aggregation.hpp"

#include <doctest/doctest.h>

#include "tests/solver/system/sample_systems.hpp"

using namespace anisofront;

TEST_SUITE("unit") {
  TEST_CASE("weak couplings go to the diagonal so that row sums stay") {
    const SparseRows matrix = difference_laplacian(20, 1000);
    const SparseRows filtered = filtered_matrix(matrix, 0.4);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(400);
    CHECK((matrix * ones - filtered * ones).norm() < 1e-9);
    for (Index row = 0; row < 400; ++row)
      for (SparseRows::InnerIterator entry(filtered, row); entry; ++entry)
        CHECK((entry.col() - row) % 20 == 0);  // along y only
  }

  TEST_CASE("aggregates follow the strong direction") {
    const Aggregates aggregates = aggregate(filtered_matrix(difference_laplacian(30, 1000), 0.4));
    CHECK(aggregates.count == 300);
    for (Index i = 0; i < 900; ++i)
      for (Index j = 0; j < i; ++j)
        if (aggregates.of_unknown[i] == aggregates.of_unknown[j]) REQUIRE((i - j) % 30 == 0);
  }

  TEST_CASE("every coupled unknown has an aggregate and every aggregate an unknown") {
    const Aggregates aggregates = aggregate(filtered_matrix(difference_laplacian(31, 1), 0.4));
    std::vector<int> size(aggregates.count);
    for (const Index a : aggregates.of_unknown) {
      REQUIRE(a >= 0);
      REQUIRE(a < aggregates.count);
      ++size[a];
    }
    for (const int s : size) CHECK(s > 0);
    CHECK(aggregates.count < 961 / 3);
  }

  TEST_CASE("an unknown without couplings stays on the fine level") {
    const Eigen::Matrix3d matrix{{1, 0, 0}, {0, 2, -1}, {0, -1, 2}};
    const SparseRows filtered = filtered_matrix(SparseRows(matrix.sparseView()), 0.4);
    const Aggregates aggregates = aggregate(filtered);
    CHECK(aggregates.of_unknown == std::vector<Index>{kNoIndex, 0, 0});
    const Eigen::MatrixXd prolongation(smoothed_prolongation(filtered, aggregates));
    CHECK(prolongation(0, 0) == 0);
    CHECK(prolongation(1, 0) > 0);
  }

  TEST_CASE("prolongation keeps constants where the matrix does") {
    const SparseRows matrix = difference_laplacian(40, 1);
    const SparseRows filtered = filtered_matrix(matrix, 0.4);
    const Aggregates aggregates = aggregate(filtered);
    const Eigen::VectorXd fine =
        smoothed_prolongation(filtered, aggregates) * Eigen::VectorXd::Ones(aggregates.count);
    for (const int y : {5, 20, 34})
      for (const int x : {3, 17, 36}) CHECK(fine[40 * y + x] == doctest::Approx(1));
  }
}
