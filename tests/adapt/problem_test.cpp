#include "adapt/problem.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

ScalarProblem layer_problem(double epsilon) {
  const ExactSolution exact = product_layer(epsilon * epsilon, 1);
  ScalarProblem problem{epsilon * epsilon, 1, exact.source, {}};
  for (const Index side : {kBottom, kRight, kTop, kLeft})
    problem.dirichlet.push_back({side, [](Point) { return 0.; }});
  return problem;
}

AdaptSettings with_vertices(double vertices) {
  AdaptSettings settings;
  settings.target_vertices = vertices;
  return settings;
}

AdaptSettings with_error(double error) {
  AdaptSettings settings;
  settings.target_error = error;
  return settings;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the analysis of the layer problem reports dofs and errors and asks for the target") {
    const Mesh mesh = square_mesh(24);
    const Analysis a =
        analyse_scalar(layer_problem(0.1), product_layer(0.01, 1), with_vertices(900))(mesh, 0);
    CHECK(a.dofs == 625);
    CHECK(a.metric.size() == 625);
    CHECK(*a.error.relative_energy > 0.02);
    CHECK(*a.error.relative_energy < 0.2);
    CHECK(*a.error.effectivity == doctest::Approx(1).epsilon(0.1));
    CHECK(expected_vertices(mesh, a.metric) == doctest::Approx(900).epsilon(1e-3));
    CHECK(a.vertex_fields[0].name == "u");
    CHECK(a.vertex_fields[1].name == "error");
    CHECK(a.vertex_fields[1].values.size() == 625);
    CHECK(a.target == TargetState::none);
    CHECK(a.warnings.empty());
  }

  TEST_CASE("the metric is fine across the layers and coarse along them") {
    const Mesh mesh = square_mesh(24);
    const Analysis a = analyse_scalar(layer_problem(0.1), {}, with_vertices(500))(mesh, 0);
    const Index middle_of_left = 12 * 25, centre = 12 * 25 + 12;
    const Metric& side = a.metric[middle_of_left];
    CHECK(side.m11 > 20 * side.m22);
    CHECK(side.m11 > 5 * a.metric[centre].m11);
    CHECK_FALSE(a.error.relative_energy.has_value());
    CHECK_FALSE(a.error.effectivity.has_value());
    CHECK(*a.error.estimate > 0);
  }

  TEST_CASE("isotropic analyses give equal sizes in all directions") {
    AdaptSettings settings = with_vertices(500);
    settings.mode = AdaptMode::isotropic;
    for (const Metric& m :
         analyse_scalar(layer_problem(0.1), {}, settings)(square_mesh(16), 0).metric) {
      CHECK(m.m11 == m.m22);
      CHECK(m.m12 == 0);
    }
  }

  TEST_CASE("a target error asks for vertices in proportion to its inverse square") {
    const Mesh mesh = square_mesh(32);
    const ExactSolution exact = product_layer(0.01, 1);
    const Analyse probe = analyse_scalar(layer_problem(0.1), exact, with_error(1e-9));
    const double error = *probe(mesh, 0).error.relative_energy;
    const auto vertices = [&](double target) {
      const Analysis a = analyse_scalar(layer_problem(0.1), exact, with_error(target))(mesh, 0);
      CHECK(a.target == TargetState::missed);
      return expected_vertices(mesh, a.metric);
    };
    // Aimed 5 percent below the target, at most twice the vertices.
    CHECK(vertices(0.8 * error) == doctest::Approx(1089 / (0.8 * 0.8 * 0.95 * 0.95)).epsilon(2e-3));
    CHECK(vertices(1e-9) == doctest::Approx(2 * 1089).epsilon(2e-3));
    const Analyse easy = analyse_scalar(layer_problem(0.1), exact, with_error(1.01 * error));
    CHECK(easy(mesh, 0).target == TargetState::reached);
  }

  TEST_CASE("the estimate of the first meshes neither ends the loop nor shrinks the mesh") {
    const Mesh mesh = square_mesh(16);
    const Analyse analyse = analyse_scalar(layer_problem(0.1), {}, with_error(0.5));
    const Analysis first = analyse(mesh, 0), later = analyse(mesh, 2);
    CHECK(*first.error.estimate < 0.4);
    CHECK(first.target == TargetState::missed);
    CHECK(expected_vertices(mesh, first.metric) == doctest::Approx(289).epsilon(1e-3));
    CHECK(later.target == TargetState::reached);
    CHECK(expected_vertices(mesh, later.metric) < 200);
  }

  TEST_CASE("limits that forbid the target are reported as a warning with both numbers") {
    AdaptSettings settings = with_vertices(5000);
    settings.limits.hmin = 0.1;
    const Analysis a = analyse_scalar(layer_problem(0.1), {}, settings)(square_mesh(16), 0);
    REQUIRE(a.warnings.size() == 1);
    CHECK(a.warnings[0].find("5000 were asked for") != std::string::npos);
  }

  TEST_CASE("one target must be given and not two") {
    CHECK_THROWS_AS(analyse_scalar(layer_problem(0.1), {}, {}), UsageError);
    AdaptSettings both = with_vertices(100);
    both.target_error = 0.1;
    CHECK_THROWS_AS(analyse_scalar(layer_problem(0.1), {}, both), UsageError);
    CHECK_THROWS_AS(analyse_scalar(layer_problem(0.1), {}, with_error(-1)), UsageError);
  }

  TEST_CASE("a prescribed metric is sampled at the vertices of quadrilaterals too") {
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {3, 0}, {3, 1}};
    mesh.quads = {{0, 1, 2, 3}, {1, 4, 5, 2}};
    mesh.quad_regions = {1, 1};
    const auto jump = [](Point p) { return metric_from_size(p.x < 2 ? 0.1 : 100); };
    const Analysis plain = analyse_prescribed(jump)(mesh, 1);
    REQUIRE(plain.metric.size() == 6);
    CHECK(plain.metric[4].m11 == doctest::Approx(1e-4));
    // Over the edge of length 2 the size may grow by 2 ln 1.5 (see limit_gradation).
    const Analysis graded = analyse_prescribed(jump, 1.5)(mesh, 1);
    for (const std::size_t v : {4u, 5u})
      CHECK(principal_axes(graded.metric[v]).h1 ==
            doctest::Approx(0.1 + 2 * std::log(1.5)).epsilon(1e-3));
  }

  TEST_CASE("a prescribed metric is sampled at the vertices") {
    const Mesh mesh = square_mesh(2);
    const Analysis a = analyse_prescribed([](Point p) {
      return Metric{1 + p.x, 0, 4 + p.y};
    })(mesh, 0);
    REQUIRE(a.metric.size() == 9);
    CHECK(a.metric[5] == Metric{2, 0, 4.5});
    CHECK(a.dofs == 0);
  }

  TEST_CASE("a prescribed metric that is not positive definite is refused with its place") {
    const Analyse analyse = analyse_prescribed([](Point p) { return Metric{1, p.x + p.y, 1}; });
    CHECK_THROWS_WITH_AS(analyse(square_mesh(2), 0), doctest::Contains("(1.000000, 0.000000)"),
                         InputError);
  }
}
