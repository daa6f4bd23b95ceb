#include "solver/system/linear_solve.hpp"

#include <limits>

#include <doctest/doctest.h>
#include <omp.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/system/sample_systems.hpp"

using namespace anisofront;

namespace {

LinearOptions with(LinearMethod method) {
  LinearOptions options;
  options.method = method;
  return options;
}

constexpr LinearMethod kSymmetricMethods[] = {LinearMethod::automatic, LinearMethod::simplicial,
                                              LinearMethod::supernodal, LinearMethod::multigrid,
                                              LinearMethod::general};
constexpr LinearMethod kCholesky[] = {LinearMethod::simplicial, LinearMethod::supernodal};

/// The biharmonic operator with w = dw/dn = 0 along a bar of n inner points, times its solution
/// x_i = i + 1: the condition is of the order n^4.
LinearSystem clamped_bar(int n) {
  Eigen::MatrixXd bar = Eigen::MatrixXd::Zero(n, n);
  constexpr double kStencil[] = {6, -4, 1};
  for (int i = 0; i < n; ++i)
    for (int j = std::max(0, i - 2); j < std::min(n, i + 3); ++j)
      bar(i, j) = kStencil[std::abs(i - j)];
  bar(0, 0) = bar(n - 1, n - 1) = 7;
  return sparse_system(bar, bar * Eigen::VectorXd::LinSpaced(n, 1, n));
}

double exact_error(const Eigen::VectorXd& solution) {
  const auto n = solution.size();
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(n, 1, static_cast<double>(n));
  return (solution - exact).norm() / exact.norm();
}

int digits_equal(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return static_cast<int>((a.array() == b.array()).count());
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("every method solves a positive definite system as dense elimination does") {
    for (const LinearMethod method : kSymmetricMethods)
      for (const int unknowns : {1, 2, 17, 120}) {
        const Eigen::MatrixXd matrix = random_positive_definite(unknowns, 7);
        const Eigen::VectorXd b = sample_load(unknowns);
        const Eigen::VectorXd dense = matrix.fullPivLu().solve(b);
        const LinearResult result = solve_linear(sparse_system(matrix, b), with(method));
        CAPTURE(result.report.method);
        CHECK((result.solution - dense).norm() < 1e-12 * dense.norm());
        CHECK(result.report.residual <= 1e-12);
        CHECK(result.report.unknowns == unknowns);
      }
  }

  TEST_CASE("a matrix that is not symmetric goes to LU whatever method is wanted") {
    LinearOptions options = with(LinearMethod::supernodal);
    options.symmetric = false;
    for (const unsigned seed : {1u, 2u, 3u}) {
      const Eigen::MatrixXd matrix = random_unsymmetric(80, seed);
      const Eigen::VectorXd b = sample_load(80);
      const LinearResult result = solve_linear(sparse_system(matrix, b), options);
      const Eigen::VectorXd dense = matrix.fullPivLu().solve(b);
      CHECK((result.solution - dense).norm() < 1e-12 * dense.norm());
      CHECK(result.report.residual <= 1e-12);
      CHECK(doctest::Contains("LU").checkWith(result.report.method.c_str()));
    }
  }

  TEST_CASE("units of very different size cost no digits") {
    const int n = 60;
    const Eigen::MatrixXd matrix = random_positive_definite(n, 3);
    Eigen::VectorXd units(n);
    for (int i = 0; i < n; ++i) units[i] = std::pow(10., i % 17 - 8);
    const Eigen::VectorXd x = sample_load(n).cwiseQuotient(units);
    const Eigen::MatrixXd scaled = units.asDiagonal() * matrix * units.asDiagonal();
    const Eigen::VectorXd b = units.asDiagonal() * (matrix * sample_load(n));
    for (const LinearMethod method : kCholesky) {
      const LinearResult result = solve_linear(sparse_system(scaled, b), with(method));
      CHECK((result.solution - x).cwiseQuotient(x).cwiseAbs().maxCoeff() < 1e-12);
      CHECK(result.report.condition < 1e4);
    }
  }

  TEST_CASE("refinement reaches its bar where one solve loses most digits") {
    for (const LinearMethod method : kCholesky) {
      const LinearResult result = solve_linear(clamped_bar(3000), with(method));
      CHECK(result.report.condition > 1e11);
      CHECK(result.report.residual <= 1e-12);
      CHECK(result.report.refinements >= 1);
      CHECK(exact_error(result.solution) < 1e-11);
      LinearOptions once = with(method);
      once.max_refinements = 0;
      const LinearResult rough = solve_linear(clamped_bar(3000), once);
      CHECK(exact_error(rough.solution) > 1e-9);
    }
  }

  TEST_CASE("the condition of a Laplacian is estimated to a factor of two") {
    const int n = 40;
    const LinearSystem system{difference_laplacian(n, 1), Eigen::VectorXd::Ones(n * n)};
    // largest by smallest eigenvalue in closed form: cot^2(pi / (2 (n + 1)))
    const double tangent = std::tan(std::acos(-1.) / (2 * (n + 1)));
    const double condition = 1 / (tangent * tangent);
    for (const LinearMethod method : kCholesky) {
      const double estimate = solve_linear(system, with(method)).report.condition;
      CHECK(estimate > 0.5 * condition);
      CHECK(estimate < 2 * condition);
    }
  }

  TEST_CASE("nonzeros of a tridiagonal factor are counted") {
    const int n = 50;
    Eigen::MatrixXd bar = 2 * Eigen::MatrixXd::Identity(n, n);
    bar.diagonal(1).setConstant(-1);
    bar.diagonal(-1).setConstant(-1);
    const LinearSystem system = sparse_system(bar, Eigen::VectorXd::Ones(n));
    const LinearReport report = solve_linear(system, with(LinearMethod::simplicial)).report;
    CHECK(report.factor_nonzeros == 2 * n - 1);
    CHECK(report.nonzeros == 3 * n - 2);
  }

  TEST_CASE("a matrix that is not positive definite is refused with the unknown") {
    Eigen::MatrixXd matrix = random_positive_definite(30, 5);
    matrix(11, 11) = -4;
    for (const LinearMethod method : kCholesky)
      CHECK_THROWS_WITH_AS(solve_linear(sparse_system(matrix, sample_load(30)), with(method)),
                           doctest::Contains("not positive definite"), MeshingError);
    const Eigen::Matrix3d indefinite{{1, 2, 0}, {2, 1, 0}, {0, 0, 1}};
    for (const LinearMethod method : kCholesky)
      CHECK_THROWS_AS(solve_linear(sparse_system(indefinite, sample_load(3)), with(method)),
                      MeshingError);
  }

  TEST_CASE("a mechanism is refused with one of its unknowns by every method") {
    Eigen::MatrixXd matrix = random_positive_definite(20, 9);
    for (const int i : {6, 13}) {  // 6 and 13 can move together
      matrix.row(i).setZero();
      matrix.col(i).setZero();
    }
    matrix(6, 6) = matrix(13, 13) = 1;
    matrix(6, 13) = matrix(13, 6) = -1;
    const LinearSystem system = sparse_system(matrix, sample_load(20));
    for (const LinearMethod method : kCholesky) {
      std::string message;
      try {
        solve_linear(system, with(method));
      } catch (const MeshingError& error) {
        message = error.what();
      }
      CAPTURE(message);
      const bool names_it = message.find("unknown 6 ") != std::string::npos ||
                            message.find("unknown 13 ") != std::string::npos;
      CHECK(names_it);
    }
    LinearOptions general;
    general.symmetric = false;
    CHECK_THROWS_WITH_AS(solve_linear(system, general), doctest::Contains("singular"),
                         MeshingError);
    CHECK_THROWS_AS(solve_linear(system, with(LinearMethod::multigrid)), MeshingError);
  }

  TEST_CASE("loads that are not finite are refused with the unknown") {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      Eigen::VectorXd b = sample_load(10);
      b[4] = bad;
      CHECK_THROWS_WITH_AS(solve_linear(sparse_system(random_positive_definite(10, 1), b)),
                           doctest::Contains("unknown 4 "), MeshingError);
    }
  }

  TEST_CASE("a matrix that is not finite is refused") {
    for (const LinearMethod method : kCholesky) {
      Eigen::MatrixXd matrix = random_positive_definite(10, 1);
      matrix(3, 3) = std::numeric_limits<double>::quiet_NaN();
      CHECK_THROWS_WITH_AS(solve_linear(sparse_system(matrix, sample_load(10)), with(method)),
                           doctest::Contains("unknown 3 "), MeshingError);
      matrix = random_positive_definite(10, 1);
      matrix(2, 3) = matrix(3, 2) = std::numeric_limits<double>::infinity();
      CHECK_THROWS_AS(solve_linear(sparse_system(matrix, sample_load(10)), with(method)),
                      MeshingError);
    }
  }

  TEST_CASE("no load gives no solution and no division by zero") {
    const LinearSystem system =
        sparse_system(random_positive_definite(25, 2), Eigen::VectorXd::Zero(25));
    for (const LinearMethod method : kSymmetricMethods) {
      const LinearResult result = solve_linear(system, with(method));
      CHECK(result.solution == Eigen::VectorXd::Zero(25));
      CHECK(result.report.residual == 0);
    }
  }

  TEST_CASE("factors that exceed the limit are refused with estimate and limit") {
    const LinearSystem system{difference_laplacian(60, 1), Eigen::VectorXd::Ones(3600)};
    for (const LinearMethod method :
         {LinearMethod::automatic, LinearMethod::simplicial, LinearMethod::supernodal}) {
      LinearOptions options = with(method);
      options.memory_limit = 100'000;
      CHECK_THROWS_WITH_AS(solve_linear(system, options), doctest::Contains("9.31e-05 GiB"),
                           BudgetError);
      options.memory_limit = 1e8;
      CHECK(solve_linear(system, options).report.residual <= 1e-12);
    }
  }

  TEST_CASE("a scalar system whose factors exceed the limit is left to multigrid") {
    const LinearSystem system{difference_laplacian(150, 1), Eigen::VectorXd::Ones(22500)};
    LinearOptions options;
    options.scalar = true;
    const LinearResult direct = solve_linear(system, options);
    CHECK(direct.report.iterations == 0);
    options.memory_limit = 1'000'000;
    const LinearResult iterative = solve_linear(system, options);
    CHECK(iterative.report.iterations > 0);
    CHECK(iterative.report.residual <= 1e-12);
    CHECK((iterative.solution - direct.solution).norm() < 1e-12 * direct.solution.norm());
  }

  TEST_CASE("results do not depend on the number of threads") {
    const LinearSystem system{difference_laplacian(150, 30), sample_load(22500)};
    for (const LinearMethod method : kSymmetricMethods) {
      omp_set_num_threads(1);
      const Eigen::VectorXd one = solve_linear(system, with(method)).solution;
      omp_set_num_threads(3);
      const Eigen::VectorXd three = solve_linear(system, with(method)).solution;
      omp_set_num_threads(omp_get_num_procs());
      CHECK(digits_equal(one, three) == 22500);
    }
  }

  TEST_CASE("the user is warned of a system beyond repair and can stop") {
    const int n = 12;
    Eigen::MatrixXd hilbert(n, n);  // condition 1.7e16
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) hilbert(i, j) = 1. / (i + j + 1);
    std::vector<std::string> warnings;
    Monitor monitor;
    monitor.warn = [&](const std::string& text) { warnings.push_back(text); };
    LinearOptions options;
    options.max_refinements = 0;
    solve_linear(sparse_system(hilbert.topLeftCorner(9, 9), sample_load(9)), options, monitor);
    REQUIRE(warnings.size() == 1);
    CHECK(doctest::Contains("ill-conditioned").checkWith(warnings[0].c_str()));
    monitor.progress = [](std::string_view, double) { return false; };
    CHECK_THROWS_AS(solve_linear(clamped_bar(5), {}, monitor), Interrupted);
  }
}
