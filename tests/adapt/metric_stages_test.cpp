#include "adapt/metric_stages.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/topology.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// A layer at x = 0 that decays over `width`, and a weak curvature in all directions.
FieldHessians layer_field(const Mesh& mesh, double width) {
  FieldHessians fields(1);
  for (const Point& p : mesh.points) {
    const double strength = std::exp(-p.x / width) / (width * width);
    fields[0].push_back({strength + 1, 0.02 * strength, 1});
  }
  return fields;
}

/// A mesh with cells shrinking towards x = 0.
Mesh graded_square(Index n) {
  return mapped(square_mesh(n), [](Point p) { return Point{p.x * p.x * p.x, p.y}; });
}

/// Largest ratio of squared lengths by which the metric of one end of an edge, grown in metric
/// space by `ratio`, exceeds that of the other end, looked for in 64 directions.
double worst_growth(const Mesh& mesh, const MetricField& field, double ratio) {
  double worst = 0;
  for (const auto& edge : mesh_edges(mesh))
    for (int k = 0; k < 2; ++k) {
      const Index p = edge[k], q = edge[1 - k];
      const double growth = 1 + length(field[p], mesh.points[q] - mesh.points[p]) * std::log(ratio);
      for (int i = 0; i < 64; ++i) {
        const Vector d{std::cos(0.05 * i), std::sin(0.05 * i)};
        worst = std::max(
            worst, squared_length(field[p], d) / (growth * growth) / squared_length(field[q], d));
      }
    }
  return worst;
}

std::string decided(const std::vector<StageSizes>& sizes, bool StageSizes::*which) {
  std::string names;
  for (const StageSizes& s : sizes)
    if (s.*which) names += s.stage;
  return names;
}

struct Decision {
  std::string h1, h2;
};
Decision decision_at(const Mesh& mesh, const StagedMetric& metric, Point p) {
  const auto sizes = explain_metric(mesh, metric.stages, p);
  return {decided(sizes, &StageSizes::decided_h1), decided(sizes, &StageSizes::decided_h2)};
}

StagedMetric staged(const Mesh& mesh, double vertices, StageOptions options,
                    const LayerSettings& layers = {}) {
  options.keep_stages = true;
  return make_metric(straight_fe_mesh(mesh), layer_field(mesh, 0.05), layers, vertices, options);
}

}  // namespace

TEST_SUITE("property") {
  TEST_CASE("the metric asks for the vertices wanted and is graded on every edge") {
    const Mesh mesh = graded_square(24);
    for (const AdaptMode mode : {AdaptMode::anisotropic, AdaptMode::isotropic})
      for (const double vertices : {300., 5000.})
        for (const double gradation : {1.3, 2.}) {
          StageOptions options{
              .limits = {.hmin = 1e-4, .hmax = 0.2, .stretch = 20, .gradation = gradation}};
          options.density.mode = mode;
          const StagedMetric metric =
              make_metric(straight_fe_mesh(mesh), layer_field(mesh, 0.01), {}, vertices, options);
          CAPTURE(vertices);
          CHECK(metric.stages.empty());
          CHECK(metric.measure == doctest::Approx(vertices).epsilon(1e-3));
          CHECK(expected_vertices(mesh, metric.field) == doctest::Approx(vertices).epsilon(1e-3));
          CHECK(worst_growth(mesh, metric.field, gradation) < 1.0011);
        }
  }
}

TEST_SUITE("unit") {
  TEST_CASE("the stages come in the order of the method and end with the metric") {
    const Mesh mesh = square_mesh(10);
    const LayerSettings layers{.tags = {kLeft}, .width = 0.01};
    const StagedMetric metric =
        staged(mesh, 500, {.limits = {.gradation = 2}, .use_layer_metric = true}, layers);
    std::vector<std::string> names;
    for (const MetricStage& stage : metric.stages) names.push_back(stage.name);
    CHECK(names == std::vector<std::string>{"density", "scaled", "layer", "size limits",
                                            "stretch limit", "gradation"});
    CHECK(metric.stages.back().field == metric.field);
    CHECK(expected_vertices(mesh, metric.stages[0].field) == doctest::Approx(500).epsilon(1e-3));
    const auto same_shape = [&](std::size_t v) {
      const Metric &a = metric.stages[0].field[v], &b = metric.stages[1].field[v];
      return a.m11 / b.m11 == doctest::Approx(a.m22 / b.m22);
    };
    CHECK(same_shape(0));
    CHECK(same_shape(60));
    CHECK(staged(mesh, 500, {}).stages.size() == 5);
  }

  TEST_CASE("where contributions set the density the curvature alone is a stage before it") {
    const Mesh mesh = square_mesh(10);
    std::vector<double> contributions(mesh.triangles.size(), 1.);
    contributions[0] = 100;
    StageOptions options;
    options.keep_stages = true;
    const FieldHessians fields{std::vector<Hessian>(mesh.points.size(), Hessian{4, 0, 1})};
    const StagedMetric metric =
        make_metric(straight_fe_mesh(mesh), fields, {}, 300, options, {contributions, 1});
    REQUIRE(metric.stages.size() == 6);
    CHECK(metric.stages[0].name == "curvature");
    CHECK(metric.stages[1].name == "density");
    CHECK(expected_vertices(mesh, metric.stages[0].field) == doctest::Approx(300).epsilon(1e-3));
    // Equal curvature asks for equal sizes, the contribution of the first element for smaller ones.
    const MetricField &by_curvature = metric.stages[0].field, &by_error = metric.stages[1].field;
    const auto first = static_cast<std::size_t>(mesh.triangles[0][0]);
    CHECK(by_curvature[first].m11 == doctest::Approx(by_curvature[60].m11));
    CHECK(by_error[first].m11 > 2 * by_error[60].m11);
    CHECK(explain_metric(mesh, metric.stages, mesh.points[first])[1].decided_h1);
  }

  TEST_CASE("where nothing limits the metric the error decides") {
    const Mesh mesh = graded_square(20);
    const auto [h1, h2] = decision_at(mesh, staged(mesh, 1000, {}), {0.2, 0.5});
    CHECK(h1 == "density");
    CHECK(h2 == "density");
  }

  TEST_CASE("hmin decides in the layer and hmax where the field is flat") {
    const Mesh mesh = graded_square(20);
    const StagedMetric metric = staged(mesh, 1500, {.limits = {.hmin = 0.01, .hmax = 0.03}});
    CHECK(decision_at(mesh, metric, {0, 0.5}).h1 == "size limits");
    CHECK(decision_at(mesh, metric, {1, 0.5}).h2 == "size limits");
    const std::string layer = describe_stages(explain_metric(mesh, metric.stages, {0, 0.5}));
    CHECK(layer.find("The size 0.01 along (1, 0.02) is set by hmin") != std::string::npos);
    const std::string flat = describe_stages(explain_metric(mesh, metric.stages, {1, 0.5}));
    CHECK(flat.find("The size 0.03 across is set by hmax") != std::string::npos);
  }

  TEST_CASE("the largest stretch decides on the long size in the layer only") {
    const Mesh mesh = graded_square(20);
    const StagedMetric metric = staged(mesh, 1000, {.limits = {.stretch = 3}});
    CHECK(decision_at(mesh, metric, {0, 0.5}).h1 == "density");
    CHECK(decision_at(mesh, metric, {0, 0.5}).h2 == "stretch limit");
    CHECK(decision_at(mesh, metric, {0.9, 0.5}).h2 == "density");
    const auto sizes = explain_metric(mesh, metric.stages, {0, 0.5});
    CHECK(sizes.back().h2 == doctest::Approx(3 * sizes.back().h1));
    CHECK(std::abs(sizes.back().e1.x) > 0.999);
  }

  TEST_CASE("the gradation decides beside a jump of sizes") {
    const Mesh mesh = square_mesh(40);
    FieldHessians fields(1);
    for (const Point& p : mesh.points)
      fields[0].push_back(p.x < 0.301 ? Hessian{1e4, 0, 1e4} : Hessian{1, 0, 1});
    const StagedMetric metric = make_metric(straight_fe_mesh(mesh), fields, {}, 2000,
                                            {.limits = {.gradation = 1.2}, .keep_stages = true});
    CHECK(decision_at(mesh, metric, {0.35, 0.5}).h1 == "gradation");
    CHECK(decision_at(mesh, metric, {0.35, 0.5}).h2 == "gradation");
    CHECK(decision_at(mesh, metric, {0.1, 0.5}).h1 == "density");
  }

  TEST_CASE("the layer metric decides at the wall and keeps its size there") {
    const Mesh mesh = graded_square(20);
    const LayerSettings layers{.tags = {kLeft}, .width = 1e-3};
    const StagedMetric metric = staged(mesh, 800, {.use_layer_metric = true}, layers);
    CHECK(metric.measure == doctest::Approx(800).epsilon(1e-3));
    CHECK(decision_at(mesh, metric, {0, 0.5}).h1 == "layer");
    CHECK(decision_at(mesh, metric, {0.9, 0.5}).h1 == "density");
    CHECK(explain_metric(mesh, metric.stages, {0, 0.5}).back().h1 == doctest::Approx(5e-4));
    CHECK(describe_stages(explain_metric(mesh, metric.stages, {0, 0.5}))
              .find("The size 0.0005 along (1, 0) is set by the a-priori metric of the layer") !=
          std::string::npos);
    CHECK(staged(mesh, 800, {}, layers).stages.size() == 5);
  }

  TEST_CASE("in isotropic mode the layer metric is isotropic too") {
    const Mesh mesh = graded_square(12);
    StageOptions options{.use_layer_metric = true};
    options.density.mode = AdaptMode::isotropic;
    for (const Metric& m : staged(mesh, 3e4, options, {.tags = {kLeft}, .width = 0.05}).field) {
      CHECK(m.m11 == doctest::Approx(m.m22));
      CHECK(std::abs(m.m12) < 1e-9 * m.m11);
    }
  }

  TEST_CASE("near a wall with a layer the metric is aligned with it unless that is switched off") {
    const Mesh mesh = square_mesh(10);
    const LayerSettings layers{.tags = {kLeft}, .width = 0.01};  // aligned up to x = 0.2
    const MetricField aligned = staged(mesh, 500, {}, layers).field;
    const MetricField plain = staged(mesh, 500, {.align = false}, layers).field;
    for (const Index v : {0, 1, 2, 111 - 10}) CHECK(aligned[v].m12 == 0);
    CHECK(std::abs(aligned[4].m12) > 0);
    CHECK(std::abs(plain[0].m12) > 1e-3 * plain[0].m11);
  }

  TEST_CASE("an explanation needs the stages") {
    CHECK_THROWS_WITH_AS(explain_metric(square_mesh(1), {}, {0, 0}), doctest::Contains("not kept"),
                         InputError);
  }

  TEST_CASE("the largest stretch of plates is 150 for thin and 10 for thick ones") {
    CHECK(plate_stretch_limit(1, 1e-3) == doctest::Approx(150));
    CHECK(plate_stretch_limit(10, 0.1) == doctest::Approx(15));
    CHECK(plate_stretch_limit(1, 0.1) == doctest::Approx(10));
    CHECK(plate_stretch_limit(1, 1e-5) == doctest::Approx(150));
  }
}
