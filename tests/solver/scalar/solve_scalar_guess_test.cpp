#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "solver/scalar/scalar_basis.hpp"
#include "tests/solver/scalar/scalar_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// Harmonic.
double growing_wave(Point p) { return std::exp(p.x) * std::sin(p.y); }

ScalarProblem wave_problem() { return with_values(1, 0, 0, growing_wave); }

ScalarSolution solve_from(const FeMesh& mesh, int order, const ScalarField* guess,
                          LinearMethod method = LinearMethod::multigrid) {
  ScalarOptions options = of_order(order);
  options.linear.method = method;
  options.guess = guess;
  return solve_scalar(mesh, wave_problem(), options);
}

/// The solution on square_mesh(n) at the vertices of square_mesh(2 n), which halve its edges.
ScalarField carried_from_half(Index n, const FeMesh& fine) {
  const Mesh half = square_mesh(n);
  const auto u = solve_from(straight_fe_mesh(half), 1, nullptr).field.values;
  std::vector<double> values;
  for (Index j = 0; j <= 2 * n; ++j)
    for (Index i = 0; i <= 2 * n; ++i)
      values.push_back(0.5 * (u[j / 2 * (n + 1) + i / 2] + u[(j + 1) / 2 * (n + 1) + (i + 1) / 2]));
  return linear_field(fine, values);
}

/// The nodal values of the exact solution, which are no discrete solution.
ScalarField nodal_values(const FeMesh& mesh, int order) {
  ScalarField field{order, make_dof_map(mesh, scalar_layout(order)), {}, {}};
  for (const Point& p : mesh.mesh.points) field.values.push_back(growing_wave(p));
  if (order == 2)
    for (const Point& p : mesh.edge_points) field.values.push_back(growing_wave(p));
  return field;
}

double largest_difference(const ScalarField& a, const ScalarField& b) {
  double difference = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    difference = std::max(difference, std::abs(a.values[i] - b.values[i]));
  return difference;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the solution of a mesh half as fine saves steps") {
    const Mesh mesh = square_mesh(80);
    const FeMesh fe = straight_fe_mesh(mesh);
    const ScalarField guess = carried_from_half(40, fe);
    const ScalarSolution plain = solve_from(fe, 1, nullptr), guessed = solve_from(fe, 1, &guess);
    CHECK(plain.linear.iterations >= 12);
    CHECK(guessed.linear.iterations <= 0.85 * plain.linear.iterations);
    CHECK(guessed.linear.residual <= 1e-12);
    CHECK(largest_difference(plain.field, guessed.field) < 1e-11);
  }

  TEST_CASE("nodal values of the exact solution save steps with both orders") {
    for (const int order : {1, 2}) {
      const Mesh mesh = mixed_square(50, 50);
      const FeMesh fe = straight_fe_mesh(mesh);
      const ScalarField guess = nodal_values(fe, order);
      const ScalarSolution plain = solve_from(fe, order, nullptr);
      const ScalarSolution guessed = solve_from(fe, order, &guess);
      CHECK(guessed.linear.iterations <= 0.7 * plain.linear.iterations);
      CHECK(largest_difference(plain.field, guessed.field) < 1e-11);
      CHECK(guessed.field.inner.size() == plain.field.inner.size());
    }
  }

  TEST_CASE("values of the guess that the problem prescribes do not matter") {
    Mesh mesh = square_mesh(50);
    mesh.points.push_back({7, 7});  // of no element
    const FeMesh fe = straight_fe_mesh(mesh);
    const ScalarField guess = nodal_values(fe, 1);
    ScalarField spoilt = guess;
    for (const CurveEdge& edge : mesh.edges) spoilt.values[edge.vertices[0]] = 1e9;
    spoilt.values.back() = -1e9;
    const ScalarSolution a = solve_from(fe, 1, &guess), b = solve_from(fe, 1, &spoilt);
    CHECK(a.field.values == b.field.values);
    CHECK(a.linear.iterations == b.linear.iterations);
    CHECK(b.field.values.back() == 0);
  }

  TEST_CASE("direct methods ignore the guess") {
    const Mesh mesh = square_mesh(12);
    const FeMesh fe = straight_fe_mesh(mesh);
    const ScalarField guess = nodal_values(fe, 1);
    for (const LinearMethod method : {LinearMethod::automatic, LinearMethod::simplicial,
                                      LinearMethod::supernodal, LinearMethod::general}) {
      const auto plain = solve_from(fe, 1, nullptr, method).field.values;
      CHECK(solve_from(fe, 1, &guess, method).field.values == plain);
    }
  }

  TEST_CASE("a guess that does not fit is refused by every method") {
    const Mesh mesh = square_mesh(4), other = square_mesh(5);
    const FeMesh fe = straight_fe_mesh(mesh);
    const ScalarField too_large = nodal_values(straight_fe_mesh(other), 1);
    const ScalarField quadratic = nodal_values(fe, 2);
    ScalarField broken = nodal_values(fe, 1);
    broken.values[12] = std::numeric_limits<double>::quiet_NaN();
    for (const LinearMethod method : {LinearMethod::simplicial, LinearMethod::multigrid}) {
      CHECK_THROWS_WITH_AS(solve_from(fe, 1, &too_large, method),
                           doctest::Contains("of order 1 with 36 values, expected order 1 with 25"),
                           InputError);
      CHECK_THROWS_WITH_AS(solve_from(fe, 1, &quadratic, method),
                           doctest::Contains("expected order 1 with 25"), InputError);
      CHECK_THROWS_WITH_AS(solve_from(fe, 1, &broken, method), doctest::Contains("not finite"),
                           InputError);
    }
  }
}
