#include "mesher/front/right_angle.hpp"

#include <algorithm>
#include <random>

#include <doctest/doctest.h>

#include "tests/mesher/metric/random_metric.hpp"
#include "tests/support/work_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

WorkVertex vertex(Point p, const Metric& m) { return {p, factor_of(m), 0}; }

/// [-3, 3]^2 with a metric on a crossed grid.
BackgroundMesh background_of(const MetricFunction& metric) {
  const Mesh grid = crossed_rectangle(30, 30, {-3, -3}, {3, 3});
  return BackgroundMesh(grid, sample(grid, metric));
}

WorkVertex vertex_of(const BackgroundMesh& background, Point p) {
  WorkVertex v{p, {}, 0};
  v.r = background.factor_at(p, v.hint);
  return v;
}

/// The vector of physical space that has the components (s, t) along the principal axes, in units
/// of the sizes there.
Vector from_unit_space(const Metric& m, Vector v) {
  const PrincipalAxes axes = principal_axes(m);
  return v.x * axes.h1 * axes.e1 + v.y * axes.h2 * axes.e2;
}

/// Side of the triangle that is longest in the metric.
int longest_side(const WorkMesh& mesh, const WorkTriangle& t) {
  std::array<double, 3> length;
  for (int k = 0; k < 3; ++k)
    length[k] =
        edge_length(mesh.vertices[t.vertices[kNext[k]]], mesh.vertices[t.vertices[kPrevious[k]]]);
  return static_cast<int>(std::max_element(length.begin(), length.end()) - length.begin());
}

/// Pairs of triangles that share the longest side of both.
Index squares(const WorkMesh& mesh) {
  Index sides = 0;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    const WorkTriangle& triangle = mesh.triangles[t];
    const Index n = triangle.neighbours[longest_side(mesh, triangle)];
    if (n < 0) continue;
    const WorkTriangle& neighbour = mesh.triangles[n];
    if (neighbour.neighbours[longest_side(mesh, neighbour)] == t) ++sides;
  }
  return sides / 2;
}

void check_filled(WorkCase& work, double area, Index holes) {
  CHECK(broken_invariant(work.mesh()) == "");
  CHECK(area_of(work.mesh()) == doctest::Approx(area).epsilon(1e-12));
  const auto vertices = static_cast<Index>(work.mesh().vertices.size());
  const auto boundary = static_cast<Index>(work.mesh().segments.size());
  CHECK(live_triangles(work.mesh()) == 2 * vertices - boundary - 2 + 2 * holes);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("mu of half a unit square is 1 whichever side is the base") {
    std::mt19937_64 random(1);
    for (int i = 0; i < 50; ++i) {
      const Metric m = random_metric(random, 50);
      const WorkVertex a = vertex({0.3, 0.2}, m);
      const WorkVertex b = vertex(a.p + from_unit_space(m, {1, 0}), m);
      const WorkVertex c = vertex(a.p + from_unit_space(m, {0, 1}), m);
      CHECK(right_angle_mu(a, b, c.p, c.r) == doctest::Approx(1).epsilon(1e-9));
      CHECK(right_angle_mu(b, c, a.p, a.r) == doctest::Approx(1).epsilon(1e-9));
      CHECK(right_angle_mu(c, a, b.p, b.r) == doctest::Approx(1).epsilon(1e-9));
      CHECK(right_angle_mu(b, a, c.p, c.r) < 0);
    }
  }

  TEST_CASE("mu falls with the angle between the legs and with their lengths") {
    const Metric m{1, 0, 1};
    const WorkVertex a = vertex({0, 0}, m), b = vertex({1, 0}, m);
    // Unit legs at 60 degrees: the sine; at right angles and 1.2 long: 1 / (1 + 0.2 + 0.02).
    CHECK(right_angle_mu(a, b, {0.5, std::sqrt(0.75)}, a.r) == doctest::Approx(std::sqrt(0.75)));
    const WorkVertex far = vertex({1.2, 0}, m);
    CHECK(right_angle_mu(a, far, {0, 1.2}, a.r) == doctest::Approx(1 / 1.22));
    CHECK(right_angle_mu(a, b, {0.5, 0}, a.r) < 0);
  }

  TEST_CASE("legs are turned by 90 degrees above both ends with unit length") {
    std::mt19937_64 random(2);
    for (int i = 0; i < 50; ++i) {
      const Metric m = random_metric(random, 20);
      const BackgroundMesh background = background_of([&](Point) { return m; });
      const WorkVertex a = vertex_of(background, {0.1, 0.2});
      const double phi = 0.1 * i, l = 0.85 + 0.006 * i;
      const Vector u{l * std::cos(phi), l * std::sin(phi)};
      const WorkVertex b = vertex_of(background, a.p + from_unit_space(m, u));
      const RightAngleOffset offset = right_angle_offset(background, a, b, 2);
      REQUIRE(offset.count == 2);
      const Vector leg = from_unit_space(m, {-std::sin(phi), std::cos(phi)});
      CHECK(norm(offset.trials[0].p - (a.p + leg)) < 1e-9 * norm(leg));
      CHECK(norm(offset.trials[1].p - (b.p + leg)) < 1e-9 * norm(leg));
    }
  }

  TEST_CASE("bases longer than 1.2 are closed at 45 degrees") {
    const BackgroundMesh background = background_of([](Point) {
      return metric_from_sizes(0.2, 0.5, {1, 0});
    });
    const WorkVertex a = vertex_of(background, {0, 0});
    const WorkVertex b = vertex_of(background, {0.2, 0.5});  // (1, 1) in units of the sizes
    const RightAngleOffset offset = right_angle_offset(background, a, b, 2);
    REQUIRE(offset.count == 1);
    CHECK(norm(offset.trials[0].p - Point{0, 0.5}) < 1e-12);
    CHECK(norm(offset.midpoint - Point{0.1, 0.25}) < 1e-15);
    CHECK(right_angle_offset(background, a, vertex_of(background, {0.238, 0}), 2).count == 2);
    CHECK(right_angle_offset(background, a, vertex_of(background, {0.242, 0}), 2).count == 1);
  }

  TEST_CASE("the unit leg is measured with the sizes on its way") {
    // h = 0.3 + 0.1 y: a unit length from y = 0 up ends at 3 (exp(0.1) - 1) = 0.3155.
    const BackgroundMesh background =
        background_of([](Point p) { return metric_from_size(0.7 + 0.1 * (p.y - 4)); });
    const WorkVertex a = vertex_of(background, {0, 0}), b = vertex_of(background, {0.3, 0});
    const Point corrected = right_angle_offset(background, a, b, 2).trials[0].p;
    CHECK(corrected.x == doctest::Approx(0));
    CHECK(corrected.y == doctest::Approx(0.3155).epsilon(0.01));
    CHECK(right_angle_offset(background, a, b, 0).trials[0].p.y == doctest::Approx(0.3));
  }

  TEST_CASE("a uniform square becomes the structured pattern of 100 squares") {
    WorkCase work(square_domain(1), [](Point) { return metric_from_size(0.1); }, {0, 0}, {1, 1});
    const FrontStatistics statistics = work.advance(right_angle_front_options());
    check_filled(work, 1, 0);
    const WorkMesh& mesh = work.mesh();
    CHECK(mesh.vertices.size() == 121);
    CHECK(live_triangles(mesh) == 200);
    CHECK(squares(mesh) == 100);
    CHECK(statistics.fallbacks == 0);
    for (const WorkVertex& v : mesh.vertices) {
      CHECK(std::fabs(10 * v.p.x - std::round(10 * v.p.x)) < 1e-10);
      CHECK(std::fabs(10 * v.p.y - std::round(10 * v.p.y)) < 1e-10);
    }
    for (const WorkTriangle& t : mesh.triangles)  // half a lattice square: 45, 45 and 90 degrees
      CHECK(twice_area(mesh.vertices[t.vertices[0]].p, mesh.vertices[t.vertices[1]].p,
                       mesh.vertices[t.vertices[2]].p) == doctest::Approx(0.01));
  }

  TEST_CASE("the wall layer becomes a structured mesh") {
    // ln(0.152 / 0.002) / 0.15 = 28.9 columns and 10 rows.
    const auto wall = [](Point p) { return metric_from_sizes(0.002 + 0.15 * p.x, 0.1, {1, 0}); };
    WorkCase work(square_domain(1), wall, {0, 0}, {1, 1}, 100);
    work.advance(right_angle_front_options());
    check_filled(work, 1, 0);
    CHECK(std::abs(live_triangles(work.mesh()) - 580) <= 4);
    CHECK(squares(work.mesh()) >= 288);
    CHECK(squares(work.mesh()) <= 292);
  }

  TEST_CASE("a disc is filled with about two triangles per unit area and most of them pair up") {
    Domain domain;
    add_region(domain, "disc", 1, {add_curve(domain, "c", 1, make_circle({0, 0}, 1))}, {});
    WorkCase work(domain, [](Point) { return metric_from_size(0.05); }, {-1, -1}, {1, 1});
    work.advance(right_angle_front_options());
    std::vector<Point> polygon;
    for (const Segment& s : work.mesh().segments) polygon.push_back(work.mesh().vertices[s.a].p);
    check_filled(work, polygon_area(polygon), 0);
    const double expected = 2 * kPi / (0.05 * 0.05);
    CHECK(live_triangles(work.mesh()) == doctest::Approx(expected).epsilon(0.15));
    CHECK(2 * squares(work.mesh()) > 0.8 * live_triangles(work.mesh()));
  }
}

TEST_SUITE("property") {
  TEST_CASE("right angle fronts fill random polygons with holes under smooth and wild metrics") {
    std::mt19937_64 random(4);
    for (int i = 0; i < 40; ++i) {
      const KnownDomain known = star_domain(random);
      const MetricFunction smooth = smooth_random_metric(random, 0.06, 100, 2);
      const MetricFunction wild = RandomMetric{&random, 0.15, 1000};
      WorkCase work(known.domain, i % 2 ? smooth : wild, {-1.1, -1.1}, {1.1, 1.1}, 10);
      work.advance(right_angle_front_options());
      check_filled(work, known.area, known.holes);
    }
  }
}
