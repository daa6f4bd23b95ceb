#include "mesher/front/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <doctest/doctest.h>

#include "mesher/front/boundary_validity.hpp"
#include "mesher/front/curve_profile.hpp"
#include "mesher/geometry/error.hpp"
#include "tests/support/work_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

MetricFunction size(double h) {
  return [h](Point) { return metric_from_size(h); };
}

/// Discretisation on a grid over [low, high]; warnings are collected.
struct Result {
  Boundary boundary;
  std::vector<std::string> warnings;
  std::unique_ptr<BackgroundMesh> background;

  std::vector<Index> per_curve(std::size_t curves) const {
    std::vector<Index> count(curves, 0);
    for (const Segment& s : boundary.mesh.segments) ++count[s.curve];
    return count;
  }
  Point point(Index v) const { return boundary.mesh.vertices[v].p; }
};

Result discretise(const Domain& domain, const MetricFunction& metric, Point low, Point high,
                  Index cells = 8, const BoundaryOptions& options = {}) {
  Result result;
  const Mesh grid = crossed_rectangle(cells, cells, low, high);
  result.background = std::make_unique<BackgroundMesh>(grid, sample(grid, metric));
  Monitor monitor;
  monitor.warn = [&](const std::string& text) { result.warnings.push_back(text); };
  result.boundary = discretise_boundary(domain, grid, *result.background, options, 100000, monitor);
  CHECK(find_conflicts(result.boundary.mesh).empty());
  return result;
}

/// The text of the InputError.
std::string refusal(const Domain& domain, double h) {
  try {
    discretise(domain, size(h), {-3, -3}, {3, 3});
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

bool mentions(const std::string& text, std::initializer_list<const char*> parts) {
  return std::all_of(parts.begin(), parts.end(),
                     [&](const char* part) { return text.find(part) != std::string::npos; });
}

Domain disc(double radius, const std::vector<std::vector<Index>>& holes = {}) {
  Domain domain;
  add_curve(domain, "outer", 1, make_circle({0, 0}, radius));
  add_region(domain, "disc", 7, {0}, holes);
  return domain;
}

Index vertex_at(const WorkMesh& mesh, Point p) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (norm(mesh.vertices[v].p - p) < 1e-12) return static_cast<Index>(v);
  return kNoIndex;
}

/// Numbers of segments that start or end at the vertex.
Index degree(const WorkMesh& mesh, Index vertex) {
  Index count = 0;
  for (const Segment& s : mesh.segments) count += (s.a == vertex) + (s.b == vertex);
  return count;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the sides of Examples 1 and 2 get the paper's numbers of edges") {
    struct Row {
      MetricFunction metric;
      std::vector<Index> sides;
    };
    const Row rows[] = {{example_1_m1, {24, 24, 24, 24}},
                        {example_1_m2, {24, 24, 24, 24}},
                        {example_1, {35, 35, 35, 35}},
                        {example_2_isotropic, {200, 17, 17, 200}},
                        {example_2_anisotropic, {32, 17, 17, 32}}};
    for (const Row& row : rows) {
      const Result result = discretise(square_domain(10), row.metric, {0, 0}, {10, 10}, 200);
      CHECK(result.per_curve(4) == row.sides);
      CHECK(result.warnings.empty());
    }
  }

  TEST_CASE("segments follow the curve with rising parameters between shared ends") {
    const Result result = discretise(square_domain(1), size(0.11), {0, 0}, {1, 1});
    const WorkMesh& mesh = result.boundary.mesh;
    CHECK(mesh.vertices.size() == mesh.segments.size());
    std::array<double, 4> reached{};
    for (const Segment& s : mesh.segments) {
      CHECK(s.parameter_a == reached[s.curve]);
      reached[s.curve] = s.parameter_b;
      CHECK(s.left_region == 0);
      CHECK(s.right_region == kNoIndex);
    }
    CHECK(reached == std::array<double, 4>{1, 1, 1, 1});
    for (Index v = 0; v < static_cast<Index>(mesh.vertices.size()); ++v)
      CHECK(degree(mesh, v) == 2);
  }

  TEST_CASE("a closed curve has three edges at least") {
    const Result result = discretise(disc(0.1), size(10), {-3, -3}, {3, 3});
    REQUIRE(result.boundary.mesh.segments.size() == 3);
    for (const WorkVertex& v : result.boundary.mesh.vertices)
      CHECK(norm(v.p) == doctest::Approx(0.1).epsilon(1e-14));
  }

  TEST_CASE("chords across a thin layer are counted by their own length on closed curves too") {
    const auto radial = [](Point p) {
      return metric_from_sizes(0.02, 0.4, norm(p) > 0 ? p : Point{1, 0});
    };
    const Result result = discretise(disc(1), radial, {-1.5, -1.5}, {1.5, 1.5}, 24);
    // Tangential: 2 pi / 0.4 = 16 edges, each of which would be 1.5 or more long in the metric.
    CHECK(result.boundary.mesh.segments.size() > 17);
    Index hint = 0;
    double longest = 0, shortest = 1e300;
    for (const Segment& s : result.boundary.mesh.segments) {
      const double l = chord_length(*result.background, result.point(s.a), result.point(s.b), hint);
      longest = std::max(longest, l);
      shortest = std::min(shortest, l);
    }
    CHECK(longest < 1.45);
    CHECK(shortest > 0.5);
    CHECK(longest < 1.2 * shortest);
  }

  TEST_CASE("the chord height is limited on request") {
    BoundaryOptions options;
    options.chord_height = 1e-3;
    const Result result = discretise(disc(1), size(1), {-2, -2}, {2, 2}, 4, options);
    for (const Segment& s : result.boundary.mesh.segments) {
      const double half = 0.5 * norm(result.point(s.b) - result.point(s.a));
      CHECK(1 - std::sqrt(1 - half * half) < 1.2e-3);  // height over a chord of the unit circle
    }
    CHECK(result.boundary.mesh.segments.size() < 130);  // 70 evenly spread ones would do
  }

  TEST_CASE("curves that cross are refused with their names and the place") {
    Domain domain = square_domain(1);
    for (const auto& [name, a, b] : {std::tuple{"slit", Point{0.2, 0.2}, Point{0.8, 0.7}},
                                     std::tuple{"cut", Point{0.2, 0.6}, Point{0.8, 0.2}}})
      domain.regions[0].embedded_curves.push_back(add_curve(domain, name, 9, make_line(a, b)));
    // y: 0.2 + 0.5 t = 0.6 - 0.4 t.
    const std::string text = refusal(domain, 0.7);
    CHECK(mentions(text, {"\"slit\"", "\"cut\"", "(0.466667, 0.422222)"}));
    CHECK(mentions(text, {"common point"}));
  }

  TEST_CASE("a curve that crosses itself is refused") {
    Domain domain;
    add_curve(domain, "eight", 1,
              make_spline(std::vector<Point>{
                  {0, 0}, {1, 1}, {2, 0}, {2, 1.5}, {1, 0.2}, {-1, 2}, {-1, 0}, {0, 0}}));
    domain.regions.push_back({"r", 1, {{{0, false}}}, {}});
    CHECK(mentions(refusal(domain, 0.1), {"\"eight\"", "itself"}));
  }

  TEST_CASE("a hole that crosses the outer boundary is refused") {
    Domain domain = square_domain(1);
    const Index hole = add_curve(domain, "hole", 8, make_circle({0.9, 0.5}, 0.2));
    domain.regions[0].loops.push_back({{hole, true}});
    CHECK(mentions(refusal(domain, 0.05), {"\"hole\"", "\"side2\""}));
  }

  TEST_CASE("a thin gap between two arcs is refined until nothing crosses") {
    Domain domain;
    const double gap = 1e-4;
    add_curve(domain, "outer", 1, make_circle({0, 0}, 1));
    // Turned, so that the edges of the coarse polygons would cross.
    add_curve(domain, "inner", 2, make_ellipse({gap, 0}, 1 - 2 * gap, 1 - 2 * gap, 0.17));
    add_region(domain, "ring", 7, {0}, {{1}});
    const Result result = discretise(domain, size(0.7), {-2, -2}, {2, 2});
    CHECK(result.boundary.mesh.segments.size() > 100);  // 18 without refinement
    // The inner circle lies in the polygon of the outer one.
    std::vector<Index> outer;
    for (std::size_t i = 0; i < result.boundary.mesh.segments.size(); ++i)
      if (result.boundary.mesh.segments[i].curve == 0) outer.push_back(static_cast<Index>(i));
    for (const Segment& s : result.boundary.mesh.segments)
      if (s.curve == 1) CHECK(is_inside(result.boundary.mesh, outer, result.point(s.a)));
  }

  TEST_CASE("a hole that a coarse outer circle would leave outside makes it finer") {
    Domain domain;
    add_curve(domain, "outer", 1, make_circle({0, 0}, 1));
    // Between the circle and its inscribed triangle, far from both.
    const double phi = kPi / 3;
    add_curve(domain, "hole", 2, make_circle(0.75 * Vector{std::cos(phi), std::sin(phi)}, 0.01));
    add_region(domain, "disc", 7, {0}, {{1}});
    const Result result = discretise(domain, size(5), {-2, -2}, {2, 2});
    CHECK(result.per_curve(2)[0] > 3);
    std::vector<Index> outer;
    for (std::size_t i = 0; i < result.boundary.mesh.segments.size(); ++i)
      if (result.boundary.mesh.segments[i].curve == 0) outer.push_back(static_cast<Index>(i));
    for (const Segment& s : result.boundary.mesh.segments)
      if (s.curve == 1) CHECK(is_inside(result.boundary.mesh, outer, result.point(s.a)));
  }

  TEST_CASE("curves closer than the metric can see are warned about with names") {
    Domain domain = square_domain(1);
    const Index slit = add_curve(domain, "slit", 9, make_line({0.2, 0.001}, {0.8, 0.001}));
    domain.regions[0].embedded_curves.push_back(slit);
    const Result narrow = discretise(domain, size(0.1), {0, 0}, {1, 1});
    REQUIRE(narrow.warnings.size() == 1);
    CHECK(mentions(narrow.warnings[0], {"\"slit\"", "\"side1\"", "closer"}));
    CHECK(discretise(domain, size(0.004), {0, 0}, {1, 1}).warnings.empty());
  }

  TEST_CASE("interfaces and embedded curves know the regions on both sides") {
    Domain domain;
    const Point p[] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
    for (Index k = 0; k < 6; ++k)
      add_curve(domain, "c" + std::to_string(k), k + 1, make_line(p[k], p[(k + 1) % 6]));
    const Index interface = add_curve(domain, "interface", 9, make_line(p[1], p[4]));
    const Index slit = add_curve(domain, "slit", 10, make_line({1.3, 0.5}, {1.7, 0.5}));
    add_region(domain, "left", 1, {0, interface, 4, 5}, {});
    add_region(domain, "right", 2, {1, 2, 3, interface}, {});
    domain.regions[1].embedded_curves.push_back(slit);
    const Result result = discretise(domain, size(0.2), {0, 0}, {2, 1});
    CHECK(result.per_curve(8) == std::vector<Index>{5, 5, 5, 5, 5, 5, 5, 2});
    for (const Segment& s : result.boundary.mesh.segments) {
      if (s.curve == interface) CHECK((s.left_region == 0 && s.right_region == 1));
      if (s.curve == slit) CHECK((s.left_region == 1 && s.right_region == 1));
      if (s.curve == 2) CHECK((s.left_region == 1 && s.right_region == kNoIndex));
    }
  }

  TEST_CASE("a required point on a curve splits it there") {
    Domain domain = square_domain(1);
    domain.points = {{"sensor", 3, {0.313, 0}}, {"inside", 4, {0.5, 0.5}}, {"corner", 5, {1, 1}}};
    const Result result = discretise(domain, size(0.2), {0, 0}, {1, 1});
    const auto& vertices = result.boundary.point_vertices;
    REQUIRE(vertices.size() == 3);
    REQUIRE(vertices[0] != kNoIndex);
    CHECK(result.point(vertices[0]) == Point{0.313, 0});
    CHECK(degree(result.boundary.mesh, vertices[0]) == 2);
    CHECK(vertices[1] == kNoIndex);
    CHECK(result.point(vertices[2]) == Point{1, 1});
    CHECK(degree(result.boundary.mesh, vertices[2]) == 2);
    // 0.313 / 0.2 = 1.57 and 0.687 / 0.2 = 3.43: 2 and 3 segments.
    CHECK(result.per_curve(4) == std::vector<Index>{5, 5, 5, 5});
  }

  TEST_CASE("embedded curves and points that meet on a curve share one vertex") {
    Domain domain = square_domain(1);
    domain.points = {{"foot", 3, {0.3, 0}}};
    for (const Point tip : {Point{0.3, 0.5}, Point{0.6, 0.5}})
      domain.regions[0].embedded_curves.push_back(add_curve(
          domain, "e" + std::to_string(domain.curves.size()), 9, make_line({0.3, 0}, tip)));
    const Result result = discretise(domain, size(0.1), {0, 0}, {1, 1});
    const Index foot = vertex_at(result.boundary.mesh, {0.3, 0});
    CHECK(result.boundary.point_vertices[0] == foot);
    CHECK(degree(result.boundary.mesh, foot) == 4);
  }

  TEST_CASE("embedded curves may meet inside of another one") {
    Domain domain = square_domain(1);
    for (const auto& [a, b] :
         {std::pair{Point{0.3, 0.5}, Point{0.7, 0.5}}, std::pair{Point{0.5, 0.5}, Point{0.5, 0.8}},
          std::pair{Point{0.5, 0.5}, Point{0.5, 0.2}}})
      domain.regions[0].embedded_curves.push_back(
          add_curve(domain, "e" + std::to_string(domain.curves.size()), 9, make_line(a, b)));
    const Result result = discretise(domain, size(0.1), {0, 0}, {1, 1});
    CHECK(degree(result.boundary.mesh, vertex_at(result.boundary.mesh, {0.5, 0.5})) == 4);
  }

  TEST_CASE("a curve that bounds nothing is left out with a warning") {
    Domain domain = square_domain(1);
    add_curve(domain, "stray", 9, make_line({0.2, 0.2}, {0.8, 0.8}));
    const Result result = discretise(domain, size(0.2), {0, 0}, {1, 1});
    REQUIRE(result.warnings.size() == 1);
    CHECK(mentions(result.warnings[0], {"\"stray\"", "no region"}));
    CHECK(result.per_curve(5).back() == 0);
  }

  TEST_CASE("the number of segments is bounded") {
    const Mesh grid = crossed_square(4, 1);
    const BackgroundMesh background(grid, sample(grid, size(0.01)));
    CHECK_THROWS_AS(discretise_boundary(square_domain(1), grid, background, {}, 50), BudgetError);
    CHECK_THROWS_AS(discretise_boundary(square_domain(1), grid, background, {}, 350), BudgetError);
    CHECK_NOTHROW(discretise_boundary(square_domain(1), grid, background, {}, 400));
  }

  TEST_CASE("preset paper measures over the old segments and gets the same counts here") {
    Mesh old = crossed_square(200, 10);
    const BackgroundMesh background(old, sample(old, example_1),
                                    Interpolation::simultaneous_reduction);
    BoundaryOptions options;
    options.over_old_segments = true;
    const Boundary boundary =
        discretise_boundary(square_domain(10), old, background, options, 100000);
    CHECK(boundary.mesh.segments.size() == 140);
  }

  TEST_CASE("conflicts are crossing or touching or overlapping segments") {
    WorkMesh mesh;
    const auto segment = [&](Point a, Point b) {
      const auto v = static_cast<Index>(mesh.vertices.size());
      mesh.vertices.push_back({a, {}, 0});
      mesh.vertices.push_back({b, {}, 0});
      mesh.segments.push_back({v, v + 1, 0, 0, 1, 0, kNoIndex});
    };
    segment({0, 0}, {4, 0});
    segment({5, 0}, {6, 0});  // collinear and apart
    segment({1, 1}, {3, 1});  // parallel
    CHECK(find_conflicts(mesh).empty());
    segment({2, -1}, {2, 0.5});  // crosses the first
    auto conflicts = find_conflicts(mesh);
    REQUIRE(conflicts.size() == 1);
    CHECK(conflicts[0].first == 0);
    CHECK(conflicts[0].second == 3);
    CHECK(conflicts[0].place == Point{2, 0});
    segment({1, 0}, {1, -1});   // touches the first
    segment({5.5, 0}, {7, 0});  // overlaps the second
    CHECK(find_conflicts(mesh).size() == 3);
  }
}
