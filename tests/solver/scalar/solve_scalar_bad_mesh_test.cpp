#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/scalar/scalar_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

double plane(Point p) { return 3 - p.x + 4 * p.y; }

/// Element matrices come from tables with the first and from quadrature with the second.
std::vector<ScalarProblem> two_problems() {
  return {with_values(1, 1, 1, plane), with_values([](Point p) { return 1 + p.x; }, 1, 1, plane)};
}

void check_refused(const Mesh& mesh, const char* place) {
  for (const ScalarProblem& problem : two_problems())
    for (const int order : {1, 2})
      CHECK_THROWS_WITH_AS(solve_straight(mesh, problem, order), doctest::Contains(place),
                           InputError);
}

ScalarSolution solve_on(const Mesh& mesh, const ScalarProblem& problem, int order,
                        LinearMethod method) {
  ScalarOptions options = of_order(order);
  options.linear.method = method;
  return solve_scalar(straight_fe_mesh(mesh), problem, options);
}

/// u = 1 on one triangle, by -a Lap u + u = 1 without conditions, a small enough for thin ones.
std::vector<double> solve_on_triangle(const std::vector<Point>& corners) {
  Mesh mesh;
  mesh.points = corners;
  mesh.triangles = {{0, 1, 2}};
  ScalarProblem problem;
  problem.diffusion = 1e-20;
  problem.reaction = problem.source = 1;
  return solve_straight(mesh, problem, 1).field.values;
}

/// Vertices of no element first, last and in between, where the mesh had vertex `gap`.
Mesh with_unused_vertices(const Mesh& mesh, Index gap) {
  Mesh result = mesh;
  result.points.insert(result.points.begin() + gap, {0.5, 0.5});
  result.points.insert(result.points.begin(), {-8, 3});
  result.points.push_back({9, 9});
  const auto renumber = [gap](auto& vertices) {
    for (Index& v : vertices) v += v < gap ? 1 : 2;
  };
  for (Triangle& t : result.triangles) renumber(t);
  for (Quad& q : result.quads) renumber(q);
  for (CurveEdge& edge : result.edges) renumber(edge.vertices);
  return result;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("triangles that are turned inside out are refused with number and place") {
    Mesh mesh = square_mesh(3);
    mesh.points[5] = {0.9, 0.3};  // was (1/3, 1/3)
    check_refused(mesh, "element 4 is turned inside out or flat at (");
  }

  TEST_CASE("quadrilaterals that are turned inside out are refused with number and place") {
    Mesh mesh = square_quads(3, 3);
    mesh.points[5] = {0.9, 0.3};
    check_refused(mesh, "is turned inside out or flat at (");
  }

  TEST_CASE("flat triangles are refused even where rounding hides it") {
    // The coordinates of the first are collinear, those of the second to round-off only.
    for (const std::vector<Point>& corners :
         {std::vector<Point>{{0, 0}, {1, 2}, {2, 4}},
          {{0.1, 0.3}, {0.2, 0.6}, {0.3, 0.9}},
          {{1, 1}, {1, 1}, {2, 3}},
          {{0, 0}, {1, 0}, {0, std::numeric_limits<double>::quiet_NaN()}}})
      CHECK_THROWS_WITH_AS(solve_on_triangle(corners), doctest::Contains("element 1 is turned"),
                           InputError);
  }

  TEST_CASE("triangles as thin as 1e-10 are no flat ones") {
    for (const double u : solve_on_triangle({{3, 1}, {4, 2}, {3.5, 1.5 + 1e-10}}))
      CHECK(u == doctest::Approx(1).epsilon(1e-5));
  }

  TEST_CASE("vertices that no element has get zero with every method and change nothing else") {
    const Mesh mesh = mixed_square(24, 24), more = with_unused_vertices(mesh, 100);
    const auto problem = with_values(
        1, 2, [](Point p) { return 3 + p.x; }, plane);
    for (const LinearMethod method :
         {LinearMethod::automatic, LinearMethod::simplicial, LinearMethod::supernodal,
          LinearMethod::multigrid, LinearMethod::general})
      for (const int order : {1, 2}) {
        const auto u = solve_on(mesh, problem, order, method).field.values;
        const auto v = solve_on(more, problem, order, method).field.values;
        REQUIRE(v.size() == u.size() + 3);
        for (const std::size_t unused : {std::size_t{0}, std::size_t{101}, mesh.points.size() + 2})
          CHECK(v[unused] == 0);
        double difference = 0;
        for (std::size_t i = 0; i < u.size(); ++i) {
          const std::size_t shift = i < 100 ? 1 : i < mesh.points.size() ? 2 : 3;
          difference = std::max(difference, std::abs(u[i] - v[i + shift]));
        }
        CHECK(difference < 1e-11);
      }
  }
}
