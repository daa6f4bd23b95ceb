#include "solver/dirichlet.hpp"

#include <limits>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

DirichletCondition constant(Index tag, double value) {
  return {tag, [value](Point) { return value; }};
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a condition fixes the vertices of its curve and the first listed wins in corners") {
    const Mesh mesh = square_mesh(2);  // vertices 0 1 2 at the bottom, 0 3 6 at the left
    const std::vector<DirichletCondition> conditions{constant(kLeft, 5), constant(kBottom, 7)};
    const auto constraints = dirichlet_constraints(mesh, conditions);
    REQUIRE(constraints.size() == 5);
    const Index unknowns[] = {0, 1, 2, 3, 6};
    const double values[] = {5, 7, 7, 5, 5};
    for (int i = 0; i < 5; ++i) {
      CHECK(constraints[i].unknown == unknowns[i]);
      CHECK(constraints[i].value == values[i]);
    }
  }

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

  TEST_CASE("a tag that no edge carries is named with its group") {
    Mesh mesh = square_mesh(1);
    mesh.groups = {{1, 9, "inlet"}};
    const std::vector<DirichletCondition> conditions{constant(9, 0)};
    CHECK_THROWS_WITH_AS(dirichlet_constraints(mesh, conditions), doctest::Contains("inlet"),
                         InputError);
  }

  TEST_CASE("a boundary value that is not finite is reported with its place") {
    const std::vector<DirichletCondition> conditions{
        {kRight, [](Point p) { return 1 / (p.y - 0.5); }}};
    CHECK_THROWS_WITH_AS(dirichlet_constraints(square_mesh(2), conditions),
                         doctest::Contains("(1.000000, 0.500000)"), InputError);
  }
}
