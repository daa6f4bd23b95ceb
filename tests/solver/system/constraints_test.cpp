#include "solver/system/constraints.hpp"

#include <numbers>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

/// Symmetric, with the full pattern that the unknowns of one element have.
LinearSystem example() {
  LinearSystem s;
  s.matrix =
      Eigen::Matrix4d{{4, 1, 2, .5}, {1, 5, 3, -1}, {2, 3, 6, .2}, {.5, -1, .2, 7}}.sparseView();
  s.rhs = Eigen::Vector4d{10, 20, 30, 40};
  return s;
}

Eigen::VectorXd solution_of(const LinearSystem& s) {
  return Eigen::MatrixXd(s.matrix).lu().solve(s.rhs);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("imposed constraints move to the right-hand side and keep the matrix symmetric") {
    LinearSystem s;
    s.matrix = Eigen::Matrix3d{{4, 1, 2}, {1, 5, 3}, {2, 3, 6}}.sparseView();
    s.rhs = Eigen::Vector3d{10, 20, 30};
    const std::vector<Constraint> constraints{{1, 2.}};
    impose(constraints, s);
    const Eigen::Matrix3d expected{{4, 0, 2}, {0, 5, 0}, {2, 0, 6}};
    CHECK((Eigen::MatrixXd(s.matrix) - expected).norm() == 0);
    CHECK((s.rhs - Eigen::Vector3d{8, 10, 24}).norm() == 0);
  }

  TEST_CASE("a system that is not symmetric keeps its solution at the prescribed value") {
    LinearSystem s = example();
    s.matrix.coeffRef(0, 1) = 9;
    const Eigen::VectorXd x = solution_of(s);
    const std::vector<Constraint> constraints{{1, x[1]}};
    impose(constraints, s);
    // The second equation is gone and its unknown is known: the others must agree.
    CHECK((solution_of(s) - x).norm() < 1e-12);
  }

  TEST_CASE("frames change the components and nothing else") {
    LinearSystem s = example();
    const Eigen::VectorXd x = solution_of(s);
    const double angle = 0.7;
    const std::vector<Frame> frames{{1, {std::cos(angle), std::sin(angle)}}};
    rotate_to_frames(frames, s);
    CHECK((Eigen::MatrixXd(s.matrix) - Eigen::MatrixXd(s.matrix).transpose()).norm() < 1e-14);
    Eigen::VectorXd turned = solution_of(s);
    CHECK(turned[1] == doctest::Approx(std::cos(angle) * x[1] + std::sin(angle) * x[2]));
    rotate_back(frames, turned);
    CHECK((turned - x).norm() < 1e-13);
    rotate_to_frames(frames, turned);
    CHECK(turned[2] == doctest::Approx(std::cos(angle) * x[2] - std::sin(angle) * x[1]));
  }

  TEST_CASE("a component held along an oblique axis vanishes there") {
    LinearSystem s = example();
    const double h = std::numbers::sqrt2 / 2;
    const std::vector<Frame> frames{{0, {h, h}}};
    rotate_to_frames(frames, s);
    const std::vector<Constraint> constraints{{0, 0.}};
    impose(constraints, s);
    Eigen::VectorXd x = solution_of(s);
    rotate_back(frames, x);
    CHECK(x[0] + x[1] == doctest::Approx(0));
    CHECK(x[0] != doctest::Approx(0));
  }
}
