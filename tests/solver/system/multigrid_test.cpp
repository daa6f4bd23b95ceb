#include "solver/system/multigrid.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "solver/system/linear_solve.hpp"
#include "solver/system/scaling.hpp"
#include "tests/solver/system/sample_systems.hpp"

using namespace anisofront;

namespace {

LinearResult solve_with(const LinearSystem& system, LinearMethod method) {
  LinearOptions options;
  options.method = method;
  return solve_linear(system, options);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("multigrid gives the direct solution for isotropic and for anisotropic diffusion") {
    for (const double stretch : {1., 100., 1e4}) {
      const LinearSystem system{difference_laplacian(120, stretch), sample_load(14400)};
      const LinearResult direct = solve_with(system, LinearMethod::simplicial);
      const LinearResult iterative = solve_with(system, LinearMethod::multigrid);
      CHECK((iterative.solution - direct.solution).norm() < 1e-12 * direct.solution.norm());
      CHECK(iterative.report.residual <= 1e-12);
      CHECK(iterative.report.iterations > 5);
      CHECK(iterative.report.iterations <= 40);
    }
  }

  TEST_CASE("a good guess saves steps and a bad one costs no digits") {
    LinearOptions options;
    options.method = LinearMethod::multigrid;
    for (const double stretch : {1., 1e4}) {
      const LinearSystem system{difference_laplacian(80, stretch), sample_load(6400)};
      const Eigen::VectorXd x = solve_with(system, LinearMethod::simplicial).solution;
      const int plain = solve_with(system, LinearMethod::multigrid).report.iterations;
      const auto check_from = [&](const Eigen::VectorXd& guess, double share) {
        const LinearResult result = solve_linear(system, options, {}, &guess);
        CHECK(result.report.iterations <= share * plain);
        CHECK(result.report.residual <= 1e-12);
        CHECK((result.solution - x).norm() < 1e-12 * x.norm());
      };
      check_from(1.0001 * x, 0.8);  // the error of a solution on a coarser mesh is smooth
      check_from(-1e6 * x, 2);
      check_from(1e3 * x.norm() * sample_load(6400), 2);
    }
  }

  TEST_CASE("without a load the solution is zero from every guess") {
    const LinearSystem system{difference_laplacian(60, 1), Eigen::VectorXd::Zero(3600)};
    const Eigen::VectorXd guess = sample_load(3600);
    LinearOptions options;
    options.method = LinearMethod::multigrid;
    CHECK(solve_linear(system, options, {}, &guess).solution == Eigen::VectorXd::Zero(3600));
  }

  TEST_CASE("a guess of another size or without values is refused") {
    const LinearSystem system{difference_laplacian(5, 1), sample_load(25)};
    const Eigen::VectorXd short_guess = sample_load(24);
    CHECK_THROWS_WITH_AS(solve_linear(system, {}, {}, &short_guess),
                         doctest::Contains("has 24 values, expected one for each of the 25"),
                         InputError);
    const Eigen::VectorXd infinite = sample_load(25) / 0.;
    CHECK_THROWS_WITH_AS(solve_linear(system, {}, {}, &infinite), doctest::Contains("not finite"),
                         InputError);
  }

  TEST_CASE("steps hardly grow with the number of unknowns") {
    int steps[2];
    for (const int k : {0, 1}) {
      const int n = k == 0 ? 60 : 240;
      const LinearSystem system{difference_laplacian(n, 1), Eigen::VectorXd::Ones(n * n)};
      steps[k] = solve_with(system, LinearMethod::multigrid).report.iterations;
    }
    CHECK(steps[1] <= 1.6 * steps[0]);
  }

  TEST_CASE("a cycle is symmetric and positive definite") {
    const SparseMatrix matrix = difference_laplacian(70, 7);
    const Multigrid multigrid(matrix);
    CHECK(multigrid.levels() >= 2);
    Eigen::VectorXd a = sample_load(4900), b = Eigen::VectorXd::LinSpaced(4900, -1, 2), x, y;
    multigrid.cycle(a, x);
    multigrid.cycle(b, y);
    CHECK(b.dot(x) == doctest::Approx(a.dot(y)).epsilon(1e-12));
    CHECK(a.dot(x) > 0);
    CHECK(b.dot(y) > 0);
  }

  TEST_CASE("coarse levels cost little") {
    const SparseMatrix matrix = difference_laplacian(200, 1);
    CHECK(Multigrid(matrix).nonzeros() < 4. * double(matrix.nonZeros()));
  }

  TEST_CASE("unknowns that nothing couples to are solved too") {
    SparseMatrix matrix = difference_laplacian(60, 1);
    for (Index column = 0; column < matrix.cols(); ++column)
      for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
        if (entry.row() != column && (entry.row() % 60 == 0 || column % 60 == 0))
          entry.valueRef() = 0;  // a held side
    const LinearSystem system{matrix, sample_load(3600)};
    const LinearResult result = solve_with(system, LinearMethod::multigrid);
    for (Index i = 0; i < 3600; i += 60)
      CHECK(result.solution[i] == doctest::Approx(system.rhs[i] / 4).epsilon(1e-12));
    CHECK(result.report.residual <= 1e-12);
  }

  TEST_CASE("an indefinite matrix is refused") {
    SparseMatrix matrix = difference_laplacian(50, 1);
    matrix.coeffRef(1234, 1234) = -40;
    CHECK_THROWS_WITH_AS(solve_with({matrix, Eigen::VectorXd::Ones(2500)}, LinearMethod::multigrid),
                         doctest::Contains("not positive definite"), MeshingError);
  }
}
