#include "solver/system/gauss_seidel.hpp"

#include <doctest/doctest.h>

#include "tests/solver/system/sample_systems.hpp"

using namespace anisofront;

TEST_SUITE("unit") {
  TEST_CASE("small systems get the classical sweeps") {
    const Eigen::Matrix3d a{{4, -1, 0}, {-1, 4, -1}, {0, -1, 2}};
    const SparseRows matrix = a.sparseView();
    const GaussSeidel smoother(matrix);
    Eigen::VectorXd x, work;
    smoother.forward_from_zero(Eigen::Vector3d{4, 7, 8}, x);
    CHECK(x == Eigen::Vector3d{1, 2, 5});
    work = x;
    smoother.backward(Eigen::Vector3d{4, 7, 8}, x, work);
    // z = 5, y = (7 + 1 + 5) / 4, x = (4 + 3.25) / 4
    CHECK(x == Eigen::Vector3d{1.8125, 3.25, 5});
  }

  TEST_CASE("the backward sweep is the adjoint of the forward one over several blocks") {
    const SparseRows matrix = difference_laplacian(150, 3);
    const GaussSeidel smoother(matrix);
    const Eigen::VectorXd a = sample_load(22500), b = Eigen::VectorXd::LinSpaced(22500, -1, 1);
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(22500);
    Eigen::VectorXd forward, backward = zero, work = zero;
    smoother.forward_from_zero(a, forward);
    smoother.backward(b, backward, work);
    CHECK(b.dot(forward) == doctest::Approx(a.dot(backward)).epsilon(1e-12));
  }

  TEST_CASE("sweeps over several blocks converge") {
    const SparseRows matrix = difference_laplacian(100, 1);
    const GaussSeidel smoother(matrix);
    const Eigen::VectorXd b = Eigen::VectorXd::Zero(10000);
    Eigen::VectorXd x = sample_load(10000), work;
    double energy = x.dot(matrix * x);
    for (int sweep = 0; sweep < 10; ++sweep) {
      work = x;
      smoother.backward(b, x, work);
      const double next = x.dot(matrix * x);
      CHECK(next < energy);
      energy = next;
    }
  }
}
