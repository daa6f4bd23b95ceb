#include <array>
#include <random>

#include <doctest/doctest.h>

#include "mesher/front/advance.hpp"
#include "mesher/geometry/error.hpp"
#include "tests/support/work_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

MetricFunction size(double h) {
  return [h](Point) { return metric_from_size(h); };
}

std::vector<FrontOptions> all_options() {
  FrontOptions classes;
  classes.order = BaseOrder::metric_class;
  FrontOptions physical;
  physical.order = BaseOrder::physical_length;
  return {FrontOptions{}, classes, physical, paper_front_options(), right_angle_front_options()};
}

/// Triangles of a polygon with holes, V vertices of which B lie on the boundary: 2 V - B - 2 + 2 H.
void check_filled(WorkCase& work, const FrontStatistics& statistics, double area, Index holes) {
  CHECK(broken_invariant(work.mesh()) == "");
  CHECK(area_of(work.mesh()) == doctest::Approx(area).epsilon(1e-12));
  const auto vertices = static_cast<Index>(work.mesh().vertices.size());
  const auto boundary = static_cast<Index>(work.mesh().segments.size());
  CHECK(live_triangles(work.mesh()) == 2 * vertices - boundary - 2 + 2 * holes);
  CHECK(statistics.steps == live_triangles(work.mesh()));
  CHECK(statistics.new_vertices == vertices - boundary);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a triangle of unit sides becomes one element") {
    for (const FrontOptions& options : all_options()) {
      Domain domain;
      const std::vector<Point> corners{{0, 0}, {1, 0}, {0.5, std::sqrt(3.) / 2}};
      add_region(domain, "r", 1, add_polygon(domain, corners, "t", 1), {});
      WorkCase work(domain, size(1), {0, 0}, {1, 1});
      const FrontStatistics statistics = work.advance(options);
      CHECK(live_triangles(work.mesh()) == 1);
      CHECK(statistics.new_vertices == 0);
      check_filled(work, statistics, polygon_area(corners), 0);
    }
  }

  TEST_CASE("a square is filled with about the number of triangles that the metric asks for") {
    for (const FrontOptions& options : all_options()) {
      WorkCase work(square_domain(1), size(0.05), {0, 0}, {1, 1});
      const FrontStatistics statistics = work.advance(options);
      check_filled(work, statistics, 1, 0);
      CHECK(live_triangles(work.mesh()) > 0.8 * 923.8);  // 4 / sqrt3 / 0.05^2
      CHECK(live_triangles(work.mesh()) < 1.5 * 923.8);  // the paper forms more than preset best
    }
  }

  TEST_CASE("polygons with holes are filled exactly under wild metrics") {
    std::mt19937_64 random(1);
    for (int i = 0; i < 15; ++i) {
      const KnownDomain known = star_domain(random);
      WorkCase work(known.domain, RandomMetric{&random, 0.15, 1000}, {-1.1, -1.1}, {1.1, 1.1});
      const FrontStatistics statistics = work.advance(all_options()[i % 5]);
      check_filled(work, statistics, known.area, known.holes);
    }
  }

  TEST_CASE("an interface is an edge of both regions") {
    Domain domain;
    const Point p[] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
    for (Index k = 0; k < 6; ++k)
      add_curve(domain, "c" + std::to_string(k), k + 1, make_line(p[k], p[(k + 1) % 6]));
    const Index interface = add_curve(domain, "interface", 9, make_line(p[1], p[4]));
    add_region(domain, "left", 1, {0, interface, 4, 5}, {});
    add_region(domain, "right", 2, {1, 2, 3, interface}, {});
    WorkCase work(domain, size(0.2), {0, 0}, {2, 1});
    work.advance();
    CHECK(broken_invariant(work.mesh()) == "");
    CHECK(area_of(work.mesh()) == doctest::Approx(2).epsilon(1e-13));
    int sides = 0;
    for (const WorkTriangle& t : work.mesh().triangles)
      for (const Index n : t.neighbours)
        if (n < 0 && work.mesh().segments[~n].curve == interface) ++sides;
    CHECK(sides == 10);  // five segments, one triangle on each side
  }

  TEST_CASE("an embedded dangling curve has triangles on both sides and all around its ends") {
    Domain domain = square_domain(1);
    const Index crack = add_curve(domain, "crack", 9, make_line({0.3, 0.5}, {0.7, 0.55}));
    domain.regions[0].embedded_curves.push_back(crack);
    for (const FrontOptions& options : all_options()) {
      WorkCase work(domain, size(0.1), {0, 0}, {1, 1});
      work.advance(options);
      CHECK(broken_invariant(work.mesh()) == "");
      CHECK(area_of(work.mesh()) == doctest::Approx(1).epsilon(1e-13));
      // Euler: V - E + F = 1 and 3 F = 2 E - B, embedded segments being inner edges.
      const auto vertices = static_cast<Index>(work.mesh().vertices.size());
      CHECK(live_triangles(work.mesh()) == 2 * vertices - 40 - 2);
      int sides = 0;
      for (const WorkTriangle& t : work.mesh().triangles)
        for (const Index n : t.neighbours)
          if (n < 0 && work.mesh().segments[~n].curve == crack) ++sides;
      CHECK(sides == 8);
    }
  }

  TEST_CASE("small edges far outside the box of a coarse background are found") {
    // The circle sticks out of the inscribed square by 0.29, where the metric is finest.
    Domain domain;
    add_region(domain, "disc", 1, {add_curve(domain, "c", 1, make_circle({0, 0}, 1))}, {});
    const double s = std::sqrt(0.5);
    const auto metric = [](Point p) { return metric_from_size(p.x > 0.5 ? 0.01 : 0.3); };
    WorkCase work(domain, metric, {-s, -s}, {s, s}, 8);
    const FrontStatistics statistics = work.advance();
    std::vector<Point> polygon;
    for (const Segment& segment : work.mesh().segments)
      polygon.push_back(work.mesh().vertices[segment.a].p);
    check_filled(work, statistics, polygon_area(polygon), 0);
  }

  TEST_CASE("metrics that change wildly between look-ups leave no overlap") {
    std::mt19937_64 random(2);
    for (int i = 0; i < 30; ++i) {
      WorkCase work(square_domain(1), RandomMetric{&random, 0.1, 1000}, {0, 0}, {1, 1}, 10);
      const FrontStatistics statistics = work.advance();
      check_filled(work, statistics, 1, 0);
    }
  }

  TEST_CASE("segments that cross are reported and never loop") {
    WorkCase work(square_domain(1), size(0.5), {0, 0}, {1, 1});
    // A bow tie: the two right vertices change places.
    std::swap(work.mesh().vertices[1].p, work.mesh().vertices[2].p);
    CHECK_THROWS_AS(work.advance(), MeshingError);
  }

  TEST_CASE("progress is reported and false stops the front") {
    WorkCase work(square_domain(1), size(0.006), {0, 0}, {1, 1});
    Monitor monitor;
    double last = -1;
    monitor.progress = [&](std::string_view phase, double fraction) {
      CHECK(phase == "front");
      CHECK(fraction >= last);
      CHECK(fraction <= 1);
      last = fraction;
      return fraction < 0.4;
    };
    CHECK_THROWS_AS(advance_front(*work.background, work.mesh(), {}, work.expected(), monitor),
                    Interrupted);
    CHECK(last >= 0.4);
  }
}
