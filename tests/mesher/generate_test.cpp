#include "mesher/generate.hpp"

#include <algorithm>
#include <cstring>
#include <thread>

#include <doctest/doctest.h>

#include "mesher/background/background_mesh.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/metric/statistics.hpp"
#include "tests/support/domains.hpp"
#include "tests/support/generated.hpp"
#include "tests/support/meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

MetricFunction size(double h) {
  return [h](Point) { return metric_from_size(h); };
}

GenerateResult run(const Domain& domain, const Mesh& background, const MetricFunction& metric,
                   const GenerateOptions& options = {}, const Monitor& monitor = {}) {
  return generate(domain, background, sample(background, metric), options, monitor);
}

template <class T>
bool same_bytes(const std::vector<T>& x, const std::vector<T>& y) {
  return x.size() == y.size() &&
         (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(T)) == 0);
}

bool same_bytes(const GenerateResult& x, const GenerateResult& y) {
  return same_bytes(x.mesh.points, y.mesh.points) &&
         same_bytes(x.mesh.triangles, y.mesh.triangles) && same_bytes(x.mesh.quads, y.mesh.quads) &&
         same_bytes(x.mesh.edges, y.mesh.edges) && same_bytes(x.metric, y.metric);
}

std::string message(const Domain& domain, const Mesh& background, const MetricFunction& metric) {
  try {
    run(domain, background, metric);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// Five regions in a square of side 3: a plus of four around one, all sharing interfaces.
Domain plate_with_regions() {
  Domain domain;
  const Point outer[] = {{0, 0}, {3, 0}, {3, 3}, {0, 3}};
  const Point inner[] = {{1, 1}, {2, 1}, {2, 2}, {1, 2}};
  for (int k = 0; k < 4; ++k)
    add_curve(domain, "side" + std::to_string(k), 1 + k, make_line(outer[k], outer[(k + 1) % 4]));
  for (int k = 0; k < 4; ++k)
    add_curve(domain, "core" + std::to_string(k), 5 + k, make_line(inner[k], inner[(k + 1) % 4]));
  for (int k = 0; k < 4; ++k)
    add_curve(domain, "rib" + std::to_string(k), 9, make_line(outer[k], inner[k]));
  add_region(domain, "core", 20, {4, 5, 6, 7}, {});
  for (Index k = 0; k < 4; ++k)
    add_region(domain, "wing" + std::to_string(k), 21 + k, {k, 8 + (k + 1) % 4, 4 + k, 8 + k}, {});
  return domain;
}

/// Bars of the report against the exact formulas: what a study of five cycles leaves behind.
struct Floors {
  Index elements_low, elements_high;
  double alpha_mean, alpha_min, percent_unit, length_min, length_max;
  Index boundary_edges;
};

void check_five_cycles(const MetricFunction& metric, const Floors& floors) {
  const Domain domain = square_domain(10);
  Mesh mesh = crossed_square(2, 10);
  for (int cycle = 1; cycle <= 5; ++cycle) mesh = run(domain, mesh, metric).mesh;
  const MeshStatistics s = mesh_statistics(mesh, metric);
  CHECK(s.elements >= floors.elements_low);
  CHECK(s.elements <= floors.elements_high);
  CHECK(s.quality_mean >= floors.alpha_mean);
  CHECK(s.quality_min >= floors.alpha_min);
  CHECK(s.percent_unit >= floors.percent_unit);
  CHECK(s.length_min >= floors.length_min);
  CHECK(s.length_max <= floors.length_max);
  CHECK(s.boundary_edges == floors.boundary_edges);
  CHECK(check_mesh(mesh).area == doctest::Approx(100).epsilon(1e-12));
}

GenerateOptions quadrilaterals(Elements elements = Elements::quadrilateral) {
  GenerateOptions options;
  options.elements = elements;
  return options;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a square is meshed with nothing but convex quadrilaterals") {
    const Domain domain = square_domain(1);
    const GenerateResult result = run(domain, crossed_square(2, 1), size(0.1), quadrilaterals());
    CHECK(joined(defects_of(domain, result, 1, 0)) == "");  // corners by exact predicate
    CHECK(result.mesh.triangles.empty());
    CHECK(result.mesh.quads.size() > 70);  // 100 squares of 0.1
    CHECK(result.mesh.quads.size() < 150);
    CHECK(group_name(result.mesh, 1, 3) == "side3");
    CHECK(result.mesh.quad_regions == std::vector<Index>(result.mesh.quads.size(), 5));
    CHECK(result.mesh.corners.size() == 4);
    CHECK(result.seconds.quads > 0);
    CHECK(result.seconds.enhance == 0);
  }

  TEST_CASE("five cycles run on quadrilaterals alone") {
    const Domain domain = square_domain(1);
    const auto metric = [](Point p) { return metric_from_sizes(0.03 + 0.1 * p.x, 0.15, {1, 0}); };
    Mesh mesh = crossed_square(4, 1);
    for (int cycle = 1; cycle <= 5; ++cycle) {
      const GenerateResult result = run(domain, mesh, metric, quadrilaterals());
      CHECK(joined(defects_of(domain, result, 1, 0)) == "");
      mesh = result.mesh;
      CHECK(mesh.triangles.empty());
    }
    // Integral of 1 / ((0.03 + 0.1 x) 0.15): ln(0.13 / 0.03) / 0.015 = 97.8 unit squares.
    CHECK(mesh.quads.size() > 60);
    CHECK(mesh.quads.size() < 150);
  }

  TEST_CASE("quadrilaterals keep regions and interfaces and points") {
    Domain domain = plate_with_regions();
    domain.points = {{"inside", 40, {1.4, 1.6}}};
    const GenerateResult result = run(domain, crossed_square(3, 3), size(0.2), quadrilaterals());
    CHECK(joined(defects_of(domain, result, 9, 0)) == "");
    CHECK(result.mesh.triangles.empty());
  }

  TEST_CASE("mixed elements are triangles and quadrilaterals") {
    const Domain domain = square_domain(1);
    const GenerateResult result =
        run(domain, crossed_square(2, 1), size(0.1), quadrilaterals(Elements::mixed));
    CHECK(joined(defects_of(domain, result, 1, 0)) == "");
    CHECK(result.mesh.quads.size() > result.mesh.triangles.size());
  }

  TEST_CASE("the budget of quadrilaterals counts unit squares") {
    GenerateOptions options = quadrilaterals();
    options.max_elements = 1000;
    CHECK_THROWS_WITH_AS(run(square_domain(1), crossed_square(2, 1), size(0.01), options),
                         doctest::Contains("about 10000 elements"), BudgetError);
  }

  TEST_CASE("the preset paper converts to quadrilaterals as published") {
    CHECK(generate_options(Preset::best).quads.method == QuadMethod::best);
    CHECK(generate_options(Preset::paper).quads.method == QuadMethod::paper);
    CHECK(generate_options(Preset::paper).elements == Elements::triangle);
  }

  TEST_CASE("a square is meshed with names and tags and corners") {
    const Domain domain = square_domain(1);
    const GenerateResult result = run(domain, crossed_square(2, 1), size(0.1));
    CHECK(joined(defects_of(domain, result, 1, 0)) == "");
    CHECK(result.mesh.edges.size() == 40);
    CHECK(result.mesh.triangles.size() > 200);  // 4 / sqrt3 / 0.01 = 231
    CHECK(result.mesh.triangles.size() < 262);
    CHECK(group_name(result.mesh, 1, 3) == "side3");
    CHECK(group_name(result.mesh, 2, 5) == "domain");
    CHECK(result.mesh.corners.size() == 4);
    for (const Index region : result.mesh.triangle_regions) CHECK(region == 5);
    for (const CurveEdge& edge : result.mesh.edges) {  // the domain lies to the left
      const Point a = result.mesh.points[edge.vertices[0]],
                  b = result.mesh.points[edge.vertices[1]];
      CHECK(cross(b - a, Point{0.5, 0.5} - a) > 0);
    }
  }

  TEST_CASE("the result carries the background metric at its vertices") {
    const auto metric = [](Point p) { return metric_from_size(0.1 + 0.1 * p.x); };
    const GenerateResult result = run(square_domain(1), crossed_square(2, 1), metric);
    REQUIRE(result.metric.size() == result.mesh.points.size());
    for (std::size_t v = 0; v < result.metric.size(); ++v)
      CHECK(principal_axes(result.metric[v]).h1 ==
            doctest::Approx(0.1 + 0.1 * result.mesh.points[v].x).epsilon(1e-9));
  }

  TEST_CASE("several regions share their interfaces and keep their tags") {
    const Domain domain = plate_with_regions();
    for (const double h : {0.1, 0.7, 5.}) {
      const GenerateResult result = run(domain, crossed_square(3, 3), size(h));
      CHECK(joined(defects_of(domain, result, 9, 0)) == "");
      std::vector<double> area(5, 0);
      for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
        const auto& v = result.mesh.triangles[t];
        area[result.mesh.triangle_regions[t] - 20] +=
            0.5 * twice_area(result.mesh.points[v[0]], result.mesh.points[v[1]],
                             result.mesh.points[v[2]]);
      }
      CHECK(area[0] == doctest::Approx(1).epsilon(1e-12));
      for (int k = 1; k < 5; ++k) CHECK(area[k] == doctest::Approx(2).epsilon(1e-12));
    }
  }

  TEST_CASE("embedded curves and required points are kept through remeshing") {
    Domain domain = square_domain(1);
    domain.regions[0].embedded_curves = {
        add_curve(domain, "crack", 30, make_line({0.2, 0.3}, {0.6, 0.4})),
        add_curve(domain, "ring", 31, make_circle({0.6, 0.7}, 0.15)),
        add_curve(domain, "root", 32, make_line({1, 0.4}, {0.8, 0.45}))};
    domain.points = {{"inside", 40, {0.61, 0.69}},
                     {"edge", 41, {0.37, 0}},
                     {"corner", 42, {1, 1}},
                     {"tip", 43, {0.6, 0.4}},
                     {"plain", 0, {0.1, 0.9}}};
    Mesh mesh = crossed_square(2, 1);
    for (const double h : {0.1, 0.03, 0.5}) {
      const GenerateResult result = run(domain, mesh, size(h));
      CHECK(joined(defects_of(domain, result, 1, 0)) == "");
      mesh = result.mesh;
      CHECK(mesh.required_vertices.size() == 5);
    }
  }

  TEST_CASE("circles and ellipses and splines keep their vertices on the curve") {
    Domain domain;
    add_curve(domain, "outer", 1, make_ellipse({0, 0}, 3, 2, 0.3));
    add_curve(domain, "hole", 2, make_circle({0.5, 0.2}, 0.6));
    add_curve(
        domain, "blob", 3,
        make_spline(std::vector<Point>{{-1.5, 0}, {-1, -0.4}, {-0.6, 0}, {-1, 0.5}, {-1.5, 0}}));
    add_region(domain, "disc", 7, {0}, {{1}, {2}});
    Mesh mesh = crossed_rectangle(4, 4, {-3, -3}, {3, 3});
    for (const double h : {0.3, 0.1, 1.}) {
      const GenerateResult result = run(domain, mesh, size(h));
      CHECK(joined(defects_of(domain, result, -1, 2)) == "");
      mesh = result.mesh;
      if (h == 0.1) {
        double exact = kPi * (6 - 0.36);  // the blob is about 0.63
        CHECK(check_mesh(mesh).area < exact - 0.5);
        CHECK(check_mesh(mesh).area > exact - 0.75);
      }
    }
  }

  TEST_CASE("equal input gives equal bytes in threads too") {
    const Domain domain = square_domain(10);
    const Mesh background = crossed_square(8, 10);
    for (const Preset preset : {Preset::best, Preset::paper}) {
      const GenerateOptions options = generate_options(preset);
      const GenerateResult first = run(domain, background, example_1_m1, options);
      std::array<GenerateResult, 3> others;
      std::vector<std::thread> threads;
      for (GenerateResult& other : others)
        threads.emplace_back([&] { other = run(domain, background, example_1_m1, options); });
      for (std::thread& thread : threads) thread.join();
      for (const GenerateResult& other : others) CHECK(same_bytes(first, other));
    }
  }

  TEST_CASE("too many elements are refused before meshing with the estimate") {
    bool asked = false;
    Monitor monitor;
    monitor.progress = [&](std::string_view, double) { return asked = true; };
    GenerateOptions options;
    options.max_elements = 1000;
    try {
      run(square_domain(1), crossed_square(2, 1), size(0.01), options, monitor);
      FAIL("not refused");
    } catch (const BudgetError& error) {
      const std::string text = error.what();
      CHECK(text.find("23094") != std::string::npos);  // 4 / sqrt3 * 1e4
      CHECK(text.find("1000") != std::string::npos);
      CHECK(error.kind() == ErrorKind::budget);
    }
    CHECK_FALSE(asked);
    CHECK_NOTHROW(run(square_domain(1), crossed_square(2, 1), size(0.06), options));
  }

  TEST_CASE("cancelling in any phase throws Interrupted") {
    for (const std::string_view wanted : {"front", "enhance"}) {
      Monitor monitor;
      monitor.progress = [&](std::string_view phase, double) { return phase != wanted; };
      CHECK_THROWS_AS(run(square_domain(1), crossed_square(2, 1), size(0.008), {}, monitor),
                      Interrupted);
    }
  }

  TEST_CASE("bad metrics and domains are refused with the place") {
    const Mesh background = crossed_square(2, 1);
    CHECK(message(square_domain(1), background, [](Point p) {
            return p == Point{1, 0.5} ? Metric{1, 3, 1} : Metric{};
          }).find("vertex 6 (1.0") != std::string::npos);
    Domain open = square_domain(1);
    open.regions[0].loops[0].pop_back();
    CHECK(message(open, background, size(0.1)).find("side3") != std::string::npos);
    CHECK_THROWS_AS(run(Domain{}, background, size(0.1)), InputError);
    Domain outside = square_domain(1);
    outside.points = {{"far", 1, {7.25, 8}}};
    CHECK(message(outside, background, size(0.1)).find("(7.25") != std::string::npos);
    CHECK_THROWS_AS(generate(square_domain(1), background, MetricField(3), {}), InputError);
  }

  TEST_CASE("gradation limits how fast sizes grow") {
    const auto jump = [](Point p) { return metric_from_size(p.x < 0.3 ? 0.02 : 1); };
    GenerateOptions options;
    const GenerateResult plain = run(square_domain(1), crossed_square(16, 1), jump, options);
    options.gradation = 1.3;
    const GenerateResult graded = run(square_domain(1), crossed_square(16, 1), jump, options);
    CHECK(graded.mesh.triangles.size() > plain.mesh.triangles.size());
    double largest = 0;
    for (const Metric& m : graded.metric) largest = std::max(largest, principal_axes(m).h2);
    CHECK(largest < 0.02 + 0.75 * std::log(1.3) + 0.02);  // h grows by ln(1.3) per unit of length
  }

  TEST_CASE("a metric far coarser than the domain leaves the coarsest mesh") {
    const GenerateResult square = run(square_domain(1), crossed_square(2, 1), size(1e6));
    CHECK(square.mesh.triangles.size() == 2);
    Domain disc;
    add_region(disc, "disc", 1, {add_curve(disc, "c", 1, make_circle({0, 0}, 1))}, {});
    CHECK(run(disc, crossed_rectangle(2, 2, {-1, -1}, {1, 1}), size(1e6)).mesh.triangles.size() ==
          1);
  }
}

TEST_SUITE("golden") {
  // Floors of the issue, exact metric, preset best, five cycles from the 2 x 2 crossed squares.
  TEST_CASE("Example 1 M1") {
    check_five_cycles(example_1_m1, {712, 785, 0.96, 0.70, 99.9, 0.68, 1.45, 96});
  }
  TEST_CASE("Example 1 M2") {
    check_five_cycles(example_1_m2, {712, 785, 0.96, 0.70, 99.9, 0.68, 1.45, 96});
  }
  TEST_CASE("Example 1 intersected") {
    check_five_cycles(example_1, {3260, 3600, 0.97, 0.72, 99.97, 0.68, 1.45, 140});
  }
  TEST_CASE("Example 2 isotropic") {
    check_five_cycles(example_2_isotropic, {4700, 5100, 0.972, 0.75, 100, 0.70, 1.43, 434});
  }
  TEST_CASE("Example 2 anisotropic") {
    check_five_cycles(example_2_anisotropic, {905, 985, 0.958, 0.72, 99.9, 0.70, 1.43, 98});
  }
}
