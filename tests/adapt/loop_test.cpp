#include "adapt/loop.hpp"

#include <doctest/doctest.h>

#include "adapt/analyse.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/mesh/boundary_domain.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// n x n squares on the unit square.
Mesh square_of_quads(Index n) {
  Mesh mesh;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) mesh.points.push_back({1. * i / n, 1. * j / n});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      mesh.quads.push_back({a, a + 1, a + n + 2, a + n + 1});
    }
  mesh.quad_regions.assign(mesh.quads.size(), 1);
  return mesh;
}

/// A mesher for uniform metrics on the unit square: a grid of the size at the first vertex.
GenerateResult make_grid(const Domain&, const Mesh&, const MetricField& field,
                         const GenerateOptions&, const Monitor&) {
  GenerateResult result;
  result.mesh = square_mesh(static_cast<Index>(std::lround(std::sqrt(field[0].m11))));
  result.seconds = {1, 2, 3, 4, 5, 6};
  return result;
}

/// Asks for a grid of 4, 8, 12 ... cells and notes the mesh numbers it was called with.
Analyse growing_grid(std::vector<int>& calls) {
  return [&calls](const Mesh& mesh, int cycle) {
    calls.push_back(cycle);
    const double n = 4. * (cycle + 1);
    Analysis analysis;
    analysis.metric.assign(mesh.points.size(), Metric{n * n, 0, n * n});
    analysis.dofs = static_cast<Index>(mesh.points.size());
    analysis.metric_seconds = 10;
    return analysis;
  };
}

Analyse reaching_target_in_cycle_2(std::vector<int>& calls) {
  return [grid = growing_grid(calls)](const Mesh& mesh, int cycle) {
    Analysis analysis = grid(mesh, cycle);
    analysis.target = cycle < 2 ? TargetState::missed : TargetState::reached;
    return analysis;
  };
}

LoopInput grid_input(Analyse analyse, int cycles) {
  LoopInput input;
  input.initial = square_mesh(2);
  input.analyse = std::move(analyse);
  input.cycles = cycles;
  input.make_mesh = make_grid;
  return input;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("each cycle meshes with the metric of the cycle before and is analysed") {
    std::vector<int> calls;
    const VariantHistory history = adapt_loop(grid_input(growing_grid(calls), 3));
    CHECK(calls == std::vector<int>{0, 1, 2, 3});
    REQUIRE(history.cycles.size() == 4);
    const Index vertices[] = {9, 25, 81, 169};
    for (int k = 0; k < 4; ++k) {
      CHECK(history.cycles[k].cycle == k);
      CHECK(history.cycles[k].dofs == vertices[k]);
      CHECK(history.cycles[k].background.vertices == vertices[k]);
      CHECK_FALSE(history.cycles[k].exact.has_value());
    }
    CHECK(history.stop_reason == "finished after 3 cycles");
    CHECK(history.stopped_by == StoppedBy::cycles);
    CHECK(history.target == TargetState::none);
  }

  TEST_CASE("lengths are measured in the background and for the initial mesh in its own metric") {
    std::vector<int> calls;
    const VariantHistory history = adapt_loop(grid_input(growing_grid(calls), 1));
    // Spacing 1/2 in size 1/4, then spacing 1/4 in size 1/4.
    CHECK(history.cycles[0].background.length_min == doctest::Approx(2));
    CHECK(history.cycles[1].background.length_min == doctest::Approx(1));
    CHECK(history.cycles[1].background.length_max == doctest::Approx(std::sqrt(2)));
  }

  TEST_CASE("an exact metric is measured beside the background") {
    std::vector<int> calls;
    LoopInput input = grid_input(growing_grid(calls), 1);
    input.exact_metric = [](Point) { return Metric{64, 0, 64}; };
    const VariantHistory history = adapt_loop(input);
    REQUIRE(history.cycles[1].exact.has_value());
    CHECK(history.cycles[1].exact->length_min == doctest::Approx(2));
  }

  TEST_CASE("phase times of mesher and analysis are summed into the record") {
    std::vector<int> calls;
    const CycleSeconds seconds = adapt_loop(grid_input(growing_grid(calls), 1)).cycles[1].seconds;
    CHECK(seconds.metric == 1 + 10);
    CHECK(seconds.front == 2 + 3);
    CHECK(seconds.enhance == 4 + 5);
    CHECK(seconds.quads == 6);
  }

  TEST_CASE("quadrilaterals are counted and measured with beta") {
    std::vector<int> calls;
    LoopInput input = grid_input(growing_grid(calls), 2);
    input.make_mesh = [](const Domain&, const Mesh&, const MetricField& field,
                         const GenerateOptions&, const Monitor&) {
      GenerateResult result;
      result.mesh = square_of_quads(static_cast<Index>(std::lround(std::sqrt(field[0].m11))));
      return result;
    };
    const MeshStatistics s = adapt_loop(input).cycles[2].background;
    CHECK(s.quads == 64);  // 8 x 8 squares of the size asked for on 4 x 4 squares
    CHECK(s.triangles == 0);
    CHECK(s.quality_min == doctest::Approx(1));
    CHECK(s.length_max == doctest::Approx(1));
    CHECK(s.angle_min == doctest::Approx(90));
    CHECK(s.scaled_jacobian_min == doctest::Approx(1));
  }

  TEST_CASE("the loop stops at the mesh that reaches the target") {
    std::vector<int> calls;
    LoopInput input = grid_input(reaching_target_in_cycle_2(calls), 5);
    const VariantHistory history = adapt_loop(input);
    CHECK(history.cycles.size() == 3);
    CHECK(history.target == TargetState::reached);
    CHECK(history.stopped_by == StoppedBy::target);
    input.cycles = 1;
    CHECK(adapt_loop(input).target == TargetState::missed);
    CHECK(adapt_loop(input).stopped_by == StoppedBy::cycles);
    input.cycles = 2;  // both at once
    CHECK(adapt_loop(input).stopped_by == StoppedBy::target);
  }

  TEST_CASE("warnings of an analysis reach the record and the monitor") {
    std::vector<std::string> heard;
    Monitor monitor;
    monitor.warn = [&](const std::string& message) { heard.push_back(message); };
    const LoopInput input = grid_input(
        [](const Mesh& mesh, int) {
          Analysis analysis;
          analysis.metric.assign(mesh.points.size(), Metric{4, 0, 4});
          analysis.warnings = {"too coarse"};
          return analysis;
        },
        1);
    CHECK(adapt_loop(input, monitor).cycles[1].warnings == std::vector<std::string>{"too coarse"});
    CHECK(heard == std::vector<std::string>{"too coarse", "too coarse"});
  }

  TEST_CASE("the user can stop the loop between two cycles") {
    std::vector<int> calls;
    Monitor monitor;
    monitor.progress = [](std::string_view, double fraction) { return fraction < 0.5; };
    CHECK_THROWS_AS(adapt_loop(grid_input(growing_grid(calls), 4), monitor), Interrupted);
    CHECK(calls == std::vector<int>{0, 1, 2});
  }

  TEST_CASE("cycles that are finished when the mesher fails have been handed out") {
    std::vector<int> calls, finished;
    LoopInput input = grid_input(growing_grid(calls), 5);
    input.make_mesh = [](const Domain& domain, const Mesh& mesh, const MetricField& field,
                         const GenerateOptions& options, const Monitor& monitor) {
      if (mesh.points.size() > 9) throw MeshingError("no mesh");
      return make_grid(domain, mesh, field, options, monitor);
    };
    input.finished = [&](const CycleRecord& record, const Mesh& mesh, const Analysis& analysis) {
      CHECK(analysis.metric.size() == mesh.points.size());
      finished.push_back(record.cycle);
    };
    CHECK_THROWS_AS(adapt_loop(input), MeshingError);
    CHECK(finished == std::vector<int>{0, 1});
  }

  TEST_CASE("the reason to end is told in words") {
    std::vector<int> calls;
    LoopInput input = grid_input(reaching_target_in_cycle_2(calls), 5);
    CHECK(adapt_loop(input).stop_reason == "target error reached after 2 cycles");
    input.cycles = 1;
    CHECK(adapt_loop(input).stop_reason == "target error missed after 1 cycles");
  }

  TEST_CASE("the loop does not start a mesh beyond the budget of vertices") {
    std::vector<int> calls;
    const Analyse grid = growing_grid(calls);
    LoopInput input = grid_input(
        [&](const Mesh& mesh, int cycle) {
          Analysis analysis = grid(mesh, cycle);
          analysis.next_vertices = 100. * (cycle + 1);
          return analysis;
        },
        5);
    input.stop.max_vertices = 200;
    const VariantHistory history = adapt_loop(input);
    CHECK(history.cycles.size() == 3);
    CHECK(history.stop_reason ==
          "budget reached after 2 cycles: the next mesh would have about 300 vertices, 200 are "
          "allowed");
    CHECK(history.stopped_by == StoppedBy::budget);
  }

  TEST_CASE("the loop stops on a plateau of the estimate") {
    LoopInput input = grid_input(
        [](const Mesh& mesh, int) {
          Analysis analysis;
          analysis.metric.assign(mesh.points.size(), Metric{16, 0, 16});
          analysis.error.estimate = 0.5;
          return analysis;
        },
        9);
    input.stop.plateau = 0.05;
    const VariantHistory history = adapt_loop(input);
    CHECK(history.cycles.size() == 4);  // 9, then three times 25 vertices
    CHECK(history.stop_reason.starts_with("plateau after 3 cycles"));
    CHECK(history.stopped_by == StoppedBy::plateau);
  }

  TEST_CASE("goal and values of an analysis are recorded") {
    const LoopInput input = grid_input(
        [](const Mesh& mesh, int cycle) {
          Analysis analysis;
          analysis.metric.assign(mesh.points.size(), Metric{4, 0, 4});
          analysis.goal = GoalRecord{3. + cycle, 0.5};
          analysis.values = {{"w at centre", 2. * cycle}};
          return analysis;
        },
        1);
    const CycleRecord record = adapt_loop(input).cycles[1];
    REQUIRE(record.goal.has_value());
    CHECK(record.goal->value == 4);
    CHECK(record.goal->error == 0.5);
    REQUIRE(record.values.size() == 1);
    CHECK(record.values[0].name == "w at centre");
    CHECK(record.values[0].value == 2);
  }

  TEST_CASE("errors measured at the end complete the records of all meshes") {
    LoopInput input = grid_input(
        [](const Mesh& mesh, int cycle) {
          Analysis analysis;
          const double n = 4. * (cycle + 1);
          analysis.metric.assign(mesh.points.size(), Metric{n * n, 0, n * n});
          if (cycle > 0) analysis.error.estimate = 0.3;
          return analysis;
        },
        2);
    std::vector<std::size_t> sizes;
    input.measure_errors = [&](std::span<const Mesh> meshes) {
      for (const Mesh& mesh : meshes) sizes.push_back(mesh.points.size());
      return std::vector<double>{0.5, 0.25, 0.2};
    };
    const VariantHistory history = adapt_loop(input);
    CHECK(sizes == std::vector<std::size_t>{9, 25, 81});
    CHECK(*history.cycles[0].error.relative_energy == 0.5);
    CHECK_FALSE(history.cycles[0].error.effectivity.has_value());
    CHECK(*history.cycles[2].error.relative_energy == 0.2);
    CHECK(*history.cycles[2].error.effectivity == doctest::Approx(1.5));
  }

  TEST_CASE("a loop that goes on from finished cycles ends as one without a break") {
    std::vector<int> calls, finished, replayed;
    std::vector<FinishedCycle> cycles;
    LoopInput input = grid_input(growing_grid(calls), 3);
    input.finished = [&](const CycleRecord& record, const Mesh& mesh, const Analysis&) {
      finished.push_back(record.cycle);
      cycles.push_back({record, mesh});
    };
    input.replayed = [&](const CycleRecord& record, const Mesh& mesh, const Analysis& analysis) {
      CHECK(analysis.dofs == static_cast<Index>(mesh.points.size()));
      replayed.push_back(record.cycle);
    };
    std::size_t measured = 0;
    input.measure_errors = [&](std::span<const Mesh> meshes) {
      measured = meshes.size();
      return std::vector<double>(meshes.size(), 1.);
    };
    const VariantHistory whole = adapt_loop(input);
    CHECK(replayed.empty());
    for (const std::size_t done : {1, 2, 4}) {
      input.initial = {};  // is not needed
      input.done.assign(cycles.begin(), cycles.begin() + static_cast<std::ptrdiff_t>(done));
      input.done[0].record.dofs = -7;  // records are kept as they are
      calls.clear();
      finished.clear();
      replayed.clear();
      measured = 0;
      std::vector<FinishedCycle> kept;
      kept.swap(cycles);
      const VariantHistory rest = adapt_loop(input);
      cycles.swap(kept);
      CHECK(calls == std::vector<int>{0, 1, 2, 3});
      CHECK(finished.size() == 4 - done);
      CHECK(replayed.size() == done);
      CHECK(replayed.front() == 0);
      CHECK(replayed.back() == static_cast<int>(done) - 1);
      if (!finished.empty()) CHECK(finished.front() == static_cast<int>(done));
      CHECK(measured == 4);
      REQUIRE(rest.cycles.size() == 4);
      CHECK(rest.cycles[0].dofs == -7);
      CHECK(rest.cycles[3].dofs == whole.cycles[3].dofs);
      CHECK(rest.cycles[3].background.length_max == whole.cycles[3].background.length_max);
      CHECK(rest.stop_reason == whole.stop_reason);
    }
  }
}

TEST_SUITE("convergence") {
  TEST_CASE("five cycles resolve the layer with few vertices") {
    // FE.md: FreeFem++ needs 1460 vertices for 6.2e-3.
    const ExactSolution exact = product_layer(1e-4, 1);
    ScalarProblem problem{1e-4, 1, exact.source, {}};
    for (const Index side : {kBottom, kRight, kTop, kLeft})
      problem.dirichlet.push_back({side, [](Point) { return 0.; }});
    AdaptSettings settings;
    settings.target.vertices = 1500;
    settings.limits.gradation = 2;
    LoopInput input;
    input.initial = square_mesh(16);
    const Point corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const char* names[] = {"bottom", "right", "top", "left"};
    for (Index k = 0; k < 4; ++k)
      input.domain.curves.push_back({names[k], k + 1, make_line(corners[k], corners[(k + 1) % 4])});
    add_region(input.domain, "square", 1, {0, 1, 2, 3}, {});
    attach_to_domain(input.initial, input.domain);
    input.analyse = analyse_model(scalar_model(problem, exact), input.domain, settings);
    const CycleRecord last = adapt_loop(input).cycles.back();
    CHECK(last.dofs <= 1600);
    CHECK(*last.error.relative_energy <= 6.5e-3);
    CHECK(*last.error.effectivity == doctest::Approx(1).epsilon(0.1));
  }
}
