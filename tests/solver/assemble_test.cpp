#include "solver/assemble.hpp"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

Mesh one_triangle() {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

ScalarProblem problem_of(double diffusion, double reaction, double source) {
  return {diffusion, reaction, [source](Point) { return source; }, {}};
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("element matrix and load of the unit right triangle are the textbook ones") {
    const LinearSystem s = assemble(one_triangle(), problem_of(2, 24, 6));
    // 2 * [[1, -1/2, -1/2], [-1/2, 1/2, 0], [-1/2, 0, 1/2]] + 24 * area/12 *
    // [[2,1,1],[1,2,1],[1,1,2]]
    const Eigen::Matrix3d expected{{4, 0, 0}, {0, 3, 1}, {0, 1, 3}};
    CHECK((Eigen::MatrixXd(s.matrix) - expected).norm() < 1e-14);
    for (int i = 0; i < 3; ++i) CHECK(s.rhs[i] == doctest::Approx(1));
  }

  TEST_CASE("the load of a source of degree five is exact") {
    const ScalarProblem problem{1, 0, [](Point p) { return std::pow(p.x, 5); }, {}};
    CHECK(assemble(one_triangle(), problem).rhs[1] == doctest::Approx(1. / 56));  // int x^6
  }

  TEST_CASE("the stiffness matrix maps constants to zero and the mass matrix holds the area") {
    const Mesh mesh = perturbed_mesh(7, 0.3, 1);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(mesh.points.size());
    CHECK((assemble(mesh, problem_of(1, 0, 0)).matrix * ones).norm() < 1e-12);
    const LinearSystem s = assemble(mesh, problem_of(1, 1, 3));
    CHECK(ones.dot(s.matrix * ones) == doctest::Approx(1));
    CHECK(s.rhs.sum() == doctest::Approx(3));
  }

  TEST_CASE("the matrix has one entry per vertex and two per edge") {
    const Index n = 5;
    const SparseMatrix matrix = vertex_matrix(square_mesh(n));
    const Index edges = 3 * n * n + 2 * n;
    CHECK(matrix.nonZeros() == (n + 1) * (n + 1) + 2 * edges);
    CHECK(matrix.isCompressed());
  }

  TEST_CASE("the matrix is symmetric to the last bit") {
    const LinearSystem s = assemble(perturbed_mesh(6, 0.3, 2), problem_of(1e-4, 1, 0));
    CHECK(SparseMatrix(s.matrix.transpose()).isApprox(s.matrix, 0));
  }

  TEST_CASE("meshes and coefficients the linear triangle cannot take are refused") {
    Mesh quads = one_triangle();
    quads.quads = {{0, 1, 2, 0}};
    CHECK_THROWS_AS(assemble(quads, problem_of(1, 0, 1)), InputError);
    CHECK_THROWS_AS(assemble(Mesh{}, problem_of(1, 0, 1)), InputError);
    CHECK_THROWS_AS(assemble(one_triangle(), problem_of(0, 1, 1)), InputError);
    CHECK_THROWS_AS(assemble(one_triangle(), problem_of(1, -1, 1)), InputError);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH_AS(assemble(one_triangle(), problem_of(1, 1, nan)),
                         doctest::Contains("source is not finite at ("), InputError);
  }
}
