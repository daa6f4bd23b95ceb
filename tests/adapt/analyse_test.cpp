#include "adapt/analyse.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// A reaction-diffusion problem with layers of width 0.1; `knows` the exact solution or not.
Model layer_model(bool knows, int order = 1, std::optional<Goal> goal = {}) {
  const ExactSolution exact = product_layer(0.01, 1);
  ScalarProblem problem{0.01, 1., exact.source};
  for (const Index side : {kBottom, kRight, kTop, kLeft}) problem.dirichlet.push_back({side, 0.});
  ScalarOptions options;
  options.order = order;
  return scalar_model(std::move(problem), knows ? std::optional(exact) : std::nullopt, options,
                      {.goal = goal, .points = {{"middle", {0.5, 0.5}}}});
}

Analyse layer_analysis(bool knows, AdaptSettings settings, int order = 1) {
  return analyse_model(layer_model(knows, order), {}, std::move(settings));
}

AdaptSettings with_vertices(double vertices) {
  AdaptSettings settings;
  settings.target.vertices = vertices;
  return settings;
}

AdaptSettings with_error(double error) {
  AdaptSettings settings;
  settings.target.error = error;
  return settings;
}

const Analysis::Field& field(const std::vector<Analysis::Field>& fields, const std::string& name) {
  for (const Analysis::Field& f : fields)
    if (f.name == name) return f;
  throw std::out_of_range("no field " + name);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("from cycle 2 on the estimate decides the density and Hessians the shape") {
    const Mesh mesh = square_mesh(24);
    AdaptSettings by_hessian = with_vertices(900), by_estimate = by_hessian;
    by_hessian.equidistribute = false;
    const MetricField early = layer_analysis(false, by_estimate)(mesh, 1).metric,
                      hessian = layer_analysis(false, by_hessian)(mesh, 2).metric,
                      late = layer_analysis(false, by_estimate)(mesh, 2).metric;
    CHECK(early == hessian);
    CHECK(late != hessian);
    CHECK(expected_vertices(mesh, late) == doctest::Approx(900).epsilon(1e-3));
    const std::size_t middle_of_left = 12 * 25;
    const auto stretch = [](const Metric& m) {
      return principal_axes(m).h2 / principal_axes(m).h1;
    };
    CHECK(stretch(late[middle_of_left]) ==
          doctest::Approx(stretch(hessian[middle_of_left])).epsilon(1e-6));
  }

  TEST_CASE("elements of order 2 take their shape from the recovered stresses") {
    const Analysis a = layer_analysis(true, with_vertices(500), 2)(square_mesh(24), 0);
    CHECK(a.dofs == 49 * 49);
    CHECK(*a.error.effectivity == doctest::Approx(1).epsilon(0.15));
    const Metric& side = a.metric[12 * 25];
    CHECK(side.m11 > 20 * side.m22);
  }

  TEST_CASE("quadrilaterals of the next mesh are counted as such") {
    AdaptSettings settings = with_vertices(800);
    settings.elements = Elements::quadrilateral;
    const Mesh mesh = square_mesh(24);
    const MetricField metric = layer_analysis(false, settings)(mesh, 0).metric;
    // Vertices = quadrilaterals + boundary edges / 2 + 1, while triangles need 1 / sqrt 3 of that.
    CHECK(complexity(mesh, metric) < 800);
    CHECK(complexity(mesh, metric) > 600);
    CHECK(expected_vertices(mesh, metric) > 800);
  }

  TEST_CASE("the analysis of the layer problem reports dofs and errors and asks for the target") {
    const Mesh mesh = square_mesh(24);
    const Analysis a = layer_analysis(true, with_vertices(900))(mesh, 0);
    CHECK(a.dofs == 625);
    CHECK(a.metric.size() == 625);
    CHECK(*a.error.relative_energy > 0.02);
    CHECK(*a.error.relative_energy < 0.2);
    CHECK(*a.error.effectivity == doctest::Approx(1).epsilon(0.1));
    CHECK(expected_vertices(mesh, a.metric) == doctest::Approx(900).epsilon(1e-3));
    CHECK(field(a.vertex_fields, "u").values.size() == 625);
    CHECK(field(a.vertex_fields, "error").values.size() == 625);
    CHECK(field(a.element_fields, "indicator").values.size() == 1152);
    CHECK(a.next_vertices == doctest::Approx(900).epsilon(1e-3));
    CHECK(a.values[0].name == "middle");
    CHECK(a.values[0].value == doctest::Approx(std::pow(1 - 1 / std::cosh(5.), 2)).epsilon(1e-3));
    CHECK(a.target == TargetState::none);
    CHECK(a.warnings.empty());
  }

  TEST_CASE("the metric is fine across the layers and coarse along them") {
    const Mesh mesh = square_mesh(24);
    const Analysis a = layer_analysis(false, with_vertices(500))(mesh, 0);
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
    settings.density.mode = AdaptMode::isotropic;
    for (const Metric& m : layer_analysis(false, settings)(square_mesh(16), 0).metric) {
      CHECK(m.m11 == m.m22);
      CHECK(m.m12 == 0);
    }
  }

  TEST_CASE("a target error asks for vertices in proportion to its inverse square") {
    const Mesh mesh = square_mesh(32);
    const Analyse probe = layer_analysis(true, with_error(1e-9));
    const double error = *probe(mesh, 0).error.relative_energy;
    const auto vertices = [&](double target) {
      const Analysis a = layer_analysis(true, with_error(target))(mesh, 0);
      CHECK(a.target == TargetState::missed);
      return expected_vertices(mesh, a.metric);
    };
    // Aimed 5 percent below the target, at most twice the vertices.
    CHECK(vertices(0.8 * error) == doctest::Approx(1089 / (0.8 * 0.8 * 0.95 * 0.95)).epsilon(2e-3));
    CHECK(vertices(1e-9) == doctest::Approx(2 * 1089).epsilon(2e-3));
    const Analyse easy = layer_analysis(true, with_error(1.01 * error));
    CHECK(easy(mesh, 0).target == TargetState::reached);
  }

  TEST_CASE("the estimate of the first meshes neither ends the loop nor shrinks the mesh") {
    const Mesh mesh = square_mesh(16);
    const Analyse analyse = layer_analysis(false, with_error(0.5));
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
    const Analysis a = layer_analysis(false, settings)(square_mesh(16), 0);
    REQUIRE(a.warnings.size() == 1);
    CHECK(a.warnings[0].find("5000 were asked for") != std::string::npos);
  }

  TEST_CASE("one target must be given and not two") {
    CHECK_THROWS_AS(layer_analysis(false, {}), UsageError);
    AdaptSettings both = with_vertices(100);
    both.target.error = 0.1;
    CHECK_THROWS_AS(layer_analysis(false, both), UsageError);
    CHECK_THROWS_AS(layer_analysis(false, with_error(-1)), UsageError);
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

  TEST_CASE("a goal that the model does not have cannot steer") {
    AdaptSettings settings = with_vertices(500);
    settings.use_goal = true;
    CHECK_THROWS_WITH_AS(layer_analysis(false, settings)(square_mesh(8), 0),
                         doctest::Contains("the model has none"), UsageError);
    const Goal goal{Goal::Kind::patch_mean, {0.5, 0.5}, 0.2, 0};
    const Analysis steered =
        analyse_model(layer_model(false, 1, goal), {}, settings)(square_mesh(8), 0);
    CHECK(steered.goal.has_value());
    CHECK(steered.metric.size() == 81);
  }

  TEST_CASE("a prescribed metric with a problem needs no Hessians of it") {
    const Mesh mesh = square_mesh(8);
    const Model model = [solve = layer_model(true)](const FeMesh& fe, const Monitor& monitor) {
      SolvedModel solved = solve(fe, monitor);
      solved.curvature_values.resize(7);  // of no use: Hessians of them would be refused
      return solved;
    };
    const auto unit = [](Point) { return Metric{4, 0, 9}; };
    const Analysis a = analyse_prescribed(unit, 0, model)(mesh, 0);
    CHECK(a.dofs == 81);
    CHECK(*a.error.relative_energy > 0);
    CHECK(field(a.element_fields, "indicator").values.size() == 128);
    CHECK(a.metric[40] == Metric{4, 0, 9});
    CHECK_THROWS_AS(analyse_model(model, {}, with_vertices(500))(mesh, 0), InputError);
  }

  TEST_CASE("a solution that is there already is analysed as one that is asked for") {
    const Mesh mesh = square_mesh(12);
    const FeMesh fe = straight_fe_mesh(mesh);
    const AdaptSettings settings = with_vertices(300);
    const Analysis asked = layer_analysis(true, settings)(mesh, 2);
    const Analysis there = analyse_solved(fe, layer_model(true)(fe, {}), settings, 2);
    CHECK(there.metric == asked.metric);
    CHECK(*there.error.estimate == *asked.error.estimate);
    CHECK(there.next_vertices == asked.next_vertices);
    CHECK(there.solve_seconds == 0);
  }

  TEST_CASE("profiles of a model are handed on and their time does not count") {
    const Profile profile{"cut", {{"s", "u"}, {{0, 1}, {2, 3}}}, NumberTable{{"s"}, {{0}}}};
    const Model model = [&, solve = layer_model(true)](const FeMesh& fe, const Monitor& monitor) {
      SolvedModel solved = solve(fe, monitor);
      solved.profiles.push_back(profile);
      solved.aside_seconds += 1000;
      return solved;
    };
    const auto unit = [](Point) { return Metric{}; };
    for (const Analyse& analyse :
         {analyse_model(model, {}, with_vertices(500)), analyse_prescribed(unit, 0, model)}) {
      const Analysis a = analyse(square_mesh(8), 0);
      REQUIRE(a.profiles.size() == 1);
      CHECK(a.profiles[0].name == "cut");
      CHECK(a.profiles[0].values.rows == profile.values.rows);
      CHECK(a.profiles[0].reference->rows == profile.reference->rows);
      CHECK(a.solve_seconds < -900);
    }
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
