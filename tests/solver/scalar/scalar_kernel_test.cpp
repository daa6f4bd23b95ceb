#include "solver/scalar/scalar_kernel.hpp"

#include <doctest/doctest.h>

#include "solver/scalar/scalar_basis.hpp"
#include "solver/scalar/scalar_system.hpp"
#include "tests/solver/scalar/scalar_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

ElementSystem system_of(const Mesh& mesh, const ScalarProblem& problem, int order) {
  ElementSystem system;
  scalar_kernel(problem, order)(element_at(straight_fe_mesh(mesh), 0), system);
  return system;
}

Mesh one_triangle(Point a, Point b, Point c) {
  Mesh mesh;
  mesh.points = {a, b, c};
  mesh.triangles = {{0, 1, 2}};
  mesh.triangle_regions = {1};
  return mesh;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the matrix of the right-angled triangle is the textbook one") {
    const Mesh mesh = one_triangle({0, 0}, {2, 0}, {0, 2});
    const ElementSystem laplacian = system_of(mesh, {3., 0., 6.}, 1);
    // 3 / 2 [[2, -1, -1], [-1, 1, 0], [-1, 0, 1]], load 6 * area / 3.
    CHECK(laplacian.matrix(0, 0) == doctest::Approx(3));
    CHECK(laplacian.matrix(0, 1) == doctest::Approx(-1.5));
    CHECK(laplacian.matrix(1, 1) == doctest::Approx(1.5));
    CHECK(std::abs(laplacian.matrix(1, 2)) < 1e-15);
    CHECK(laplacian.rhs[2] == doctest::Approx(4));
    // Mass area / 12 [[2, 1, 1], ...] on top.
    const ElementSystem both = system_of(mesh, {3., 12., 0.}, 1);
    CHECK(both.matrix(1, 1) == doctest::Approx(1.5 + 4));
    CHECK(both.matrix(1, 2) == doctest::Approx(2));
  }

  TEST_CASE("quadratic triangles carry a uniform load at the midpoints of their edges") {
    const ElementSystem system = system_of(one_triangle({0, 0}, {3, 0}, {1, 2}), {1., 0., 2.}, 2);
    for (int i = 0; i < 3; ++i) {
      CHECK(std::abs(system.rhs[i]) < 1e-14);
      CHECK(system.rhs[3 + i] == doctest::Approx(2));  // 2 * area 3 / 3
    }
    // P2 mass matrix, A/180 [6 at corners, 32 on the edges]; stiffness of a linear function is 0.
    const Eigen::MatrixXd mass =
        system_of(one_triangle({0, 0}, {3, 0}, {1, 2}), {1., 180., 0.}, 2).matrix -
        system_of(one_triangle({0, 0}, {3, 0}, {1, 2}), {1., 0., 0.}, 2).matrix;
    CHECK(mass(0, 0) == doctest::Approx(3 * 6));
    CHECK(mass(3, 3) == doctest::Approx(3 * 32));
    CHECK(mass(0, 1) == doctest::Approx(3 * -1));
  }

  TEST_CASE("reference matrices and quadrature agree") {
    const Mesh mesh = one_triangle({0.3, 0.1}, {4, -0.7}, {-1, 0.4});
    const auto constant = [](double value) {
      return RegionCoefficient([value](Point) { return value; });
    };
    for (const int order : {1, 2}) {
      const auto fast = system_of(mesh, {0.7, 2., 3.}, order);
      const auto slow = system_of(mesh, {constant(0.7), constant(2), constant(3)}, order);
      const auto half = system_of(mesh, {0.7, 2., constant(3)}, order);
      CHECK((fast.matrix - slow.matrix).cwiseAbs().maxCoeff() <
            1e-13 * fast.matrix.cwiseAbs().maxCoeff());
      CHECK((fast.rhs - slow.rhs).cwiseAbs().maxCoeff() < 1e-14);
      CHECK((fast.rhs - half.rhs).cwiseAbs().maxCoeff() < 1e-14);
    }
  }
}

TEST_SUITE("property") {
  TEST_CASE("matrices without convection are symmetric to round-off") {
    for (const int order : {1, 2})
      for (const Index aspect : {1, 64}) {
        const Mesh mesh = perturbed(mixed_square(4, 4 * aspect), 4, 4 * aspect, 0.3, 5);
        const FeMesh fe = straight_fe_mesh(mesh);
        ScalarProblem problem{1., [](Point p) { return 1 + p.x; }, 0.};
        problem.fluxes = {{kLeft, 0, 3}};
        const DofMap dofs = make_dof_map(fe, scalar_layout(order));
        const SparseMatrix a = scalar_system(fe, problem, dofs, order).matrix;
        const SparseMatrix difference = a - SparseMatrix(a.transpose());
        CHECK(difference.coeffs().cwiseAbs().maxCoeff() < 1e-14 * a.coeffs().cwiseAbs().maxCoeff());
        // Constants: the stiffness vanishes, what remains is int c + int 3 over the left side.
        // (With centres eliminated a little less.)
        if (order == 1) CHECK(a.sum() == doctest::Approx(1.5 + 3).epsilon(1e-10));
      }
  }
}
