#include "solver/solve_scalar.hpp"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "solver/assemble.hpp"
#include "solver/norms.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

ScalarProblem with_values(double a, double c, const ScalarFunction& source,
                          const ScalarFunction& value) {
  ScalarProblem problem{a, c, source, {}};
  for (const Index side : {kBottom, kRight, kTop, kLeft})
    problem.dirichlet.push_back({side, value});
  return problem;
}

ErrorNorms solve_and_compare(const Mesh& mesh, const ScalarProblem& problem,
                             const ExactSolution& exact) {
  return error_norms(mesh, problem, exact, solve_scalar(mesh, problem));
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a linear solution is reproduced on a distorted mesh") {
    const auto u = [](Point p) { return 3 - p.x + 4 * p.y; };
    const Mesh mesh = perturbed_mesh(8, 0.35, 5);
    const auto values = solve_scalar(mesh, with_values(2, 0, {}, u));
    for (std::size_t v = 0; v < values.size(); ++v)
      CHECK(values[v] == doctest::Approx(u(mesh.points[v])).epsilon(1e-12));
  }

  TEST_CASE("sides without a condition carry no flux") {
    // u = cosh x / cosh 1 solves -u'' + u = 0 with u'(0) = 0 and u(1) = 1, constant in y.
    ScalarProblem problem{1, 1, {}, {{kRight, [](Point) { return 1.; }}}};
    const Mesh mesh = square_mesh(40);
    const auto values = solve_scalar(mesh, problem);
    for (std::size_t v = 0; v < values.size(); ++v)
      CHECK(values[v] == doctest::Approx(std::cosh(mesh.points[v].x) / std::cosh(1)).epsilon(1e-4));
  }

  TEST_CASE("pure reaction without boundary values returns the constant source") {
    const auto values = solve_scalar(square_mesh(3), {1, 2, [](Point) { return 10.; }, {}});
    for (const double u : values) CHECK(u == doctest::Approx(5));
  }

  TEST_CASE("a solution that is free up to a constant is refused") {
    CHECK_THROWS_WITH_AS(solve_scalar(square_mesh(3), {1, 0, {}, {}}),
                         doctest::Contains("free up to a constant"), InputError);
  }

  TEST_CASE("a part of the mesh that nothing holds is reported as singular") {
    Mesh mesh = square_mesh(2);
    const Mesh island = square_mesh(1);
    const auto offset = static_cast<Index>(mesh.points.size());
    for (const Point& p : island.points) mesh.points.push_back(p + Vector{3, 0});
    for (const auto& [a, b, c] : island.triangles)
      mesh.triangles.push_back({a + offset, b + offset, c + offset});
    const ScalarProblem problem = with_values(1, 0, {}, [](Point) { return 0.; });
    CHECK_THROWS_AS(solve_scalar(mesh, problem), MeshingError);
  }
}

TEST_SUITE("convergence") {
  TEST_CASE("the sine problem converges with order one in H1 and two in L2") {
    const ExactSolution exact = sine_product(1, 0);
    const ScalarProblem problem = with_values(1, 0, exact.source, [](Point) { return 0.; });
    ErrorNorms coarse = solve_and_compare(square_mesh(8), problem, exact);
    for (const Index n : {16, 32, 64}) {
      const ErrorNorms fine = solve_and_compare(square_mesh(n), problem, exact);
      CAPTURE(n);
      CHECK(std::log2(coarse.h1 / fine.h1) == doctest::Approx(1).epsilon(0.03));
      CHECK(std::log2(coarse.l2 / fine.l2) == doctest::Approx(2).epsilon(0.03));
      coarse = fine;
    }
  }

  TEST_CASE("the energy error squared is the energy missing from the solution") {
    // Galerkin orthogonality: |e|^2 = |u|^2 - |u_h|^2, with |u_h|^2 = int f u_h. Poisson on the
    // square with f = 1: |u|^2 = int u = 0.03514425373878842890 (FE.md 3.1).
    const ScalarProblem problem = with_values(
        1, 0, [](Point) { return 1.; }, [](Point) { return 0.; });
    double missing[2];
    for (int k = 0; k < 2; ++k) {
      const Index n = 16 << k;
      double energy = 0;
      for (const double u : solve_scalar(square_mesh(n), problem)) energy += u / (n * n);
      missing[k] = 0.03514425373878842890 - energy;
    }
    CHECK(missing[1] > 0);
    CHECK(missing[0] / missing[1] == doctest::Approx(4).epsilon(0.02));
  }

  TEST_CASE("on a stretched layer mesh the error squared is the energy missing from the solution") {
    // Cells from 0.007 to 0.08 wide; |u|^2 = 0.9603 for eps = 0.01 (FE.md 3.1).
    const auto half = [](double t) { return 0.5 * t * (0.1 + 0.9 * t); };
    const auto grade = [half](double s) { return s < 0.5 ? half(2 * s) : 1 - half(2 - 2 * s); };
    const Mesh mesh = mapped(square_mesh(24), [grade](Point p) {
      return Point{grade(p.x), grade(p.y)};
    });
    const ExactSolution exact = product_layer(1e-4, 1);
    const ScalarProblem problem = with_values(1e-4, 1, exact.source, [](Point) { return 0.; });
    const auto u = solve_scalar(mesh, problem);
    const Eigen::VectorXd load = assemble(mesh, problem).rhs;
    const double energy = load.dot(Eigen::Map<const Eigen::VectorXd>(u.data(), load.size()));
    const double error = error_norms(mesh, problem, exact, u).energy;
    CHECK(error * error == doctest::Approx(0.9603 - energy).epsilon(0.02));
  }

  TEST_CASE("the resolved layer problem converges with order one in the energy norm") {
    const ExactSolution exact = product_layer(0.01, 1);
    const ScalarProblem problem = with_values(0.01, 1, exact.source, [](Point) { return 0.; });
    const double coarse = solve_and_compare(square_mesh(40), problem, exact).relative_energy();
    const double fine = solve_and_compare(square_mesh(80), problem, exact).relative_energy();
    CHECK(std::log2(coarse / fine) == doctest::Approx(1).epsilon(0.03));
  }
}
