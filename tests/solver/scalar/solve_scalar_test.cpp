#include "solver/scalar/solve_scalar.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/scalar/scalar_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// Triangles, quadrilaterals and both, perturbed by 30 %, of 4 x 4 aspect cells.
std::vector<Mesh> patch_meshes(Index aspect) {
  const Index nx = 4, ny = 4 * aspect;
  return {perturbed(square_mesh(nx, ny), nx, ny, 0.3, 1),
          perturbed(square_quads(nx, ny), nx, ny, 0.3, 2),
          perturbed(mixed_square(nx, ny), nx, ny, 0.3, 3)};
}

double linear(Point p) { return 3 - p.x + 4 * p.y; }
double quadratic(Point p) { return 1 + p.x - 2 * p.y + p.x * p.x + 3 * p.x * p.y - 2 * p.y * p.y; }

/// Region 2 where x > 1/2.
Mesh with_two_regions(Mesh mesh) {
  const auto region_of = [&](const auto& element) {
    double x = 0;
    for (const Index v : element) x += mesh.points[v].x / static_cast<double>(element.size());
    return x > 0.5 ? 2 : 1;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    mesh.triangle_regions[t] = region_of(mesh.triangles[t]);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    mesh.quad_regions[q] = region_of(mesh.quads[q]);
  mesh.groups = {{2, 1, "copper"}, {2, 2, "steel"}, {1, kLeft, "left"}};
  return mesh;
}

/// Two squares side by side that share no vertex; the right one is region 7.
Mesh two_islands() {
  Mesh mesh = square_mesh(2);
  const Mesh island = square_mesh(1);
  const auto offset = static_cast<Index>(mesh.points.size());
  for (const Point& p : island.points) mesh.points.push_back(p + Vector{3, 0});
  for (const auto& [a, b, c] : island.triangles) {
    mesh.triangles.push_back({a + offset, b + offset, c + offset});
    mesh.triangle_regions.push_back(7);
  }
  mesh.groups.push_back({2, 7, "island"});
  return mesh;
}

void check_refused(const ScalarProblem& problem, const char* part, int order = 1) {
  CAPTURE(part);
  CHECK_THROWS_WITH_AS(solve_straight(with_two_regions(square_mesh(4)), problem, order),
                       doctest::Contains(part), InputError);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("linear solutions pass the patch test with order one at all aspects") {
    for (const Index aspect : {1, 8, 64})
      for (const Mesh& mesh : patch_meshes(aspect)) {
        CAPTURE(aspect);
        const FeMesh fe = straight_fe_mesh(mesh);
        const auto solution = solve_scalar(fe, with_values(2, 0, 0, linear));
        CHECK(nodal_error(fe, solution.field, linear) < 1e-11);
        CHECK(solution.squared_energy == doctest::Approx(2 * 17));
      }
  }

  TEST_CASE("quadratic solutions pass the patch test with order two at all aspects") {
    // Lap u = 2 - 4, so -2 Lap u = 4.
    for (const Index aspect : {1, 8, 64})
      for (const Mesh& mesh : patch_meshes(aspect)) {
        CAPTURE(aspect);
        const FeMesh fe = straight_fe_mesh(mesh);
        const auto problem = with_values(2, 0, 4, quadratic);
        CHECK(nodal_error(fe, solve_scalar(fe, problem, of_order(2)).field, quadratic) < 1e-10);
      }
  }

  TEST_CASE("coefficients that are functions pass the patch test") {
    // a = 1 + x, c = y: -div(a grad u) + c u for the linear u above is 1 + y u.
    const RegionCoefficient a([](Point p) { return 1 + p.x; });
    const RegionCoefficient c([](Point p) { return p.y; });
    const RegionCoefficient f([](Point p) { return 1 + p.y * linear(p); });
    for (const int order : {1, 2})
      for (const Mesh& mesh : patch_meshes(8)) {
        const FeMesh fe = straight_fe_mesh(mesh);
        const auto solution = solve_scalar(fe, with_values(a, c, f, linear), of_order(order));
        CHECK(nodal_error(fe, solution.field, linear) < 1e-11);
      }
  }

  TEST_CASE("sides without a condition carry no flux") {
    // u = cosh x / cosh 1 solves -u'' + u = 0 with u'(0) = 0 and u(1) = 1, constant in y.
    ScalarProblem problem;
    problem.reaction = 1;
    problem.dirichlet = {{kRight, 1}};
    const auto u = [](Point p) { return std::cosh(p.x) / std::cosh(1); };
    for (const int order : {1, 2}) {
      const Mesh mesh = square_mesh(40);
      const FeMesh fe = straight_fe_mesh(mesh);
      CHECK(nodal_error(fe, solve_scalar(fe, problem, of_order(order)).field, u) <
            (order == 1 ? 2e-4 : 1e-7));
    }
  }

  TEST_CASE("Robin and Neumann sides of a two-region bar give the closed form") {
    // (a u')' = -f, a = 1 left and 3 right of 1/2; -u'(0) + h u(0) = g, 3 u'(1) = q:
    // a u' = q + f (1 - x), u(0) = (g + q + f) / h. Piecewise quadratic: order 2 is exact.
    const double f = 2, q = -0.5, g = 1, h = 4;
    const auto integral = [&](double x) { return q * x + f * (x - x * x / 2); };
    const auto u = [&](Point p) {
      const double left = std::min(p.x, 0.5);
      return (g + q + f) / h + integral(left) + (integral(p.x) - integral(left)) / 3;
    };
    ScalarProblem problem;
    problem.diffusion.set(2, 3.);
    problem.source = f;
    problem.fluxes = {{kLeft, g, h}, {kRight, [q](Point) { return q; }, {}}};
    for (const Mesh& mesh : {square_mesh(4), square_quads(4, 3), mixed_square(6, 2)}) {
      const Mesh bar = with_two_regions(mesh);
      const FeMesh fe = straight_fe_mesh(bar);
      CHECK(nodal_error(fe, solve_scalar(fe, problem, of_order(2)).field, u) < 1e-12);
    }
  }

  TEST_CASE("a flux condition on an interface is a line source") {
    // -u'' = delta(x - 1/2) with u(0) = u(1) = 0: u = min(x, 1 - x) / 2.
    Mesh mesh = square_mesh(4);
    for (Index j = 0; j < 4; ++j) mesh.edges.push_back({{j * 5 + 2, j * 5 + 7}, 9, kNoIndex, {}});
    ScalarProblem problem;
    problem.dirichlet = {{kLeft, 0}, {kRight, 0}};
    problem.fluxes = {{9, 1, {}}};
    const FeMesh fe = straight_fe_mesh(mesh);
    CHECK(nodal_error(fe, solve_scalar(fe, problem).field,
                      [](Point p) { return 0.5 * std::min(p.x, 1 - p.x); }) < 1e-13);
  }

  TEST_CASE("pure reaction without boundary values returns the constant source") {
    ScalarProblem problem;
    problem.reaction = 2;
    problem.source = 10;
    for (const int order : {1, 2})
      for (const double u : solve_straight(mixed_square(3, 3), problem, order).field.values)
        CHECK(u == doctest::Approx(5));
  }

  TEST_CASE("a point value holds a problem without other values and sits at the nearest vertex") {
    ScalarProblem problem;
    problem.points = {{{0.51, 0.26}, 7}};
    std::vector<std::string> warnings;
    Monitor monitor;
    monitor.warn = [&](const std::string& text) { warnings.push_back(text); };
    const Mesh mesh = square_mesh(4);
    const FeMesh fe = straight_fe_mesh(mesh);
    for (const double u : solve_scalar(fe, problem, {}, monitor).field.values)
      CHECK(u == doctest::Approx(7));
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].find("(0.5, 0.25)") != std::string::npos);
    problem.points[0].at = {0.5, 0.25};
    solve_scalar(fe, problem, {}, monitor);
    CHECK(warnings.size() == 1);
  }

  TEST_CASE("where two curves meet the first condition of the list holds") {
    ScalarProblem problem;
    problem.dirichlet = {{kRight, 5}, {kBottom, 1}, {kLeft, 2}};
    const auto u = solve_straight(square_mesh(2), problem, 2).field.values;
    CHECK(u[2] == 5);
    CHECK(u[0] == 1);
    CHECK(u[6] == 2);
    problem.dirichlet = {{kLeft, 2}, {kBottom, 1}, {kRight, 5}};
    const auto v = solve_straight(square_mesh(2), problem, 2).field.values;
    CHECK(v[2] == 1);
    CHECK(v[0] == 2);
  }

  TEST_CASE("vertices that no element has do no harm") {
    Mesh mesh = square_mesh(3);
    mesh.points.insert(mesh.points.begin(), {0.5, 0.5});
    mesh.points.push_back({9, 9});
    for (auto& t : mesh.triangles)
      for (Index& v : t) ++v;
    for (auto& edge : mesh.edges)
      for (Index& v : edge.vertices) ++v;
    const auto u = solve_straight(mesh, with_values(1, 0, 0, linear), 2).field.values;
    CHECK(u[0] == 0);
    CHECK(u[17] == 0);
    CHECK(u[6] == doctest::Approx(linear(mesh.points[6])));
  }

  TEST_CASE("the result does not depend on the number of threads") {
    const Mesh mesh = mixed_square(30, 30);
    const FeMesh fe = straight_fe_mesh(mesh);
    const auto problem = with_values(
        1, 1, [](Point p) { return std::sin(9 * p.x); }, linear);
    ScalarOptions options = of_order(2);
    options.threads = 1;
    const ScalarSolution one = solve_scalar(fe, problem, options);
    options.threads = 3;
    const ScalarSolution three = solve_scalar(fe, problem, options);
    CHECK(one.field.values == three.field.values);
    CHECK(one.field.inner == three.field.inner);
    CHECK(one.squared_energy == three.squared_energy);
  }

  TEST_CASE("a solution that is free up to a constant is refused with the region") {
    check_refused({}, "region 1 (\"copper\")");
    check_refused({}, "free up to a constant", 2);
    ScalarProblem convection;
    convection.velocity_x = 1;
    check_refused(convection, "free up to a constant");
    ScalarProblem neumann;
    neumann.fluxes = {{kLeft, 1, {}}};
    check_refused(neumann, "free up to a constant");
  }

  TEST_CASE("a part of the mesh that nothing holds is refused with its region and place") {
    const Mesh mesh = two_islands();
    ScalarProblem problem = with_values(1, 0, 0, 0);
    CHECK_THROWS_WITH_AS(solve_straight(mesh, problem, 1),
                         doctest::Contains("region 7 (\"island\"), the part around (3, 0)"),
                         InputError);
    // A reaction anywhere in the part holds it.
    problem.reaction.set(7, [](Point p) { return p.x > 3.4 ? 1. : 0.; });
    problem.source.set(7, [](Point p) { return p.x > 3.4 ? 2. : 0.; });
    CHECK(solve_straight(mesh, problem, 1).field.values.back() == doctest::Approx(2));
  }

  TEST_CASE("coefficients of the wrong sign or without a value are refused with the place") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    check_refused(with_values(0, 0, 0, 0), "the diffusion is 0 at (");
    check_refused(with_values([](Point p) { return p.x - 0.5; }, 0, 0, 0), "the diffusion is -");
    check_refused(with_values(1, -2, 0, 0), "the reaction is -2 at (");
    check_refused(with_values(
                      1, 0, [nan](Point p) { return p.y > 0.9 ? nan : 0; }, 0),
                  "the source is nan at (");
    check_refused(with_values(1, 0, 0, [nan](Point p) { return p.x == 1 && p.y == 0.5 ? nan : 0; }),
                  "the boundary value on tag 2");
    ScalarProblem problem = with_values(1, 0, 0, 0);
    problem.velocity_y = nan;
    check_refused(problem, "the velocity is nan at (");
    problem = with_values(1, 0, 0, 0);
    problem.diffusion.set(2, -1.);
    check_refused(problem, "the diffusion is -1 at (", 2);
  }

  TEST_CASE("boundary data that cannot be right is refused with the place") {
    ScalarProblem problem;
    problem.fluxes = {{kLeft, 0, [](Point p) { return p.y < 0.3 ? -1. : 1.; }}};
    check_refused(problem, "the transfer coefficient is -1 at (0, ");
    problem.fluxes = {{kLeft, std::nan(""), 1}};
    check_refused(problem, "the boundary flux is nan at (0");
    problem = with_values(1, 0, 0, 0);
    problem.points = {{{0.1, 0}, 1}};
    check_refused(problem, "has another condition already");
    problem.points = {{{0.5, 0.5}, 1}, {{0.51, 0.5}, 1}};
    check_refused(problem, "has another condition already");
  }

  TEST_CASE("conditions on unknown tags and twice on one tag are refused") {
    check_refused({1., 0., 0., {{77, 0}}}, "tag 77");
    check_refused({1., 0., 0., {{kLeft, 0}, {kLeft, 1}}}, "tag 4 (\"left\") has two boundary");
    check_refused({1., 0., 0., {{kLeft, 0}}, {{kLeft, 1, {}}}},
                  "tag 4 (\"left\") has two boundary");
    check_refused({1., 0., 0., {{kLeft, 0}}, {{78, 1, {}}}}, "tag 78");
  }
}

TEST_SUITE("property") {
  TEST_CASE("turning the domain and changing the unit of length leave the solution") {
    const double angle = 37 * std::numbers::pi / 180, unit = 1e3;
    const double c = std::cos(angle), s = std::sin(angle);
    const auto moved = [&](Point p) {
      return Point{unit * (c * p.x - s * p.y), unit * (s * p.x + c * p.y)};
    };
    const auto back = [&](Point p) {
      return Point{(c * p.x + s * p.y) / unit, (-s * p.x + c * p.y) / unit};
    };
    const auto source = [](Point p) { return std::exp(p.x) * (1 + p.y); };
    const auto value = [](Point p) { return p.x * p.y; };
    ScalarProblem plain = with_values(1, 2, source, value);
    plain.velocity_x = 40;
    plain.velocity_y = -10;
    // Lengths in millimetres: a as it is, b by 1e-3, c and f by 1e-6.
    ScalarProblem turned = with_values(
        1, 2 / unit / unit, [&](Point p) { return source(back(p)) / unit / unit; },
        [&](Point p) { return value(back(p)); });
    turned.velocity_x = (40 * c + 10 * s) / unit;
    turned.velocity_y = (40 * s - 10 * c) / unit;
    for (const int order : {1, 2})
      for (const Mesh& mesh : patch_meshes(2)) {
        const auto u = solve_straight(mesh, plain, order).field.values;
        const auto v = solve_straight(mapped(mesh, moved), turned, order).field.values;
        double difference = 0;
        for (std::size_t i = 0; i < u.size(); ++i)
          difference = std::max(difference, std::abs(u[i] - v[i]));
        CHECK(difference < 1e-10);
      }
  }
}
