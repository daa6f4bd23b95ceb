#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <doctest/doctest.h>

#include "mesher/generate.hpp"
#include "tests/support/domains.hpp"
#include "tests/support/generated.hpp"
#include "tests/support/meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

double draw(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Crossed squares over the domain, a little larger.
Mesh grid_over(const Domain& domain, Index cells) {
  Point low = domain.curves[0].curve.points[0], high = low;
  for (const DomainCurve& c : domain.curves)
    for (const Point p : c.curve.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  const Vector margin = 0.03 * (high - low);
  return crossed_rectangle(cells, cells, low - margin, high + margin);
}

/// Two cycles under metrics drawn anew at every vertex: on a grid, then on the first mesh.
void check_two_cycles(const KnownDomain& known, std::mt19937_64& random, double h,
                      double max_stretch, const GenerateOptions& options) {
  Mesh background = grid_over(known.domain, 1 + static_cast<Index>(random() % 8));
  for (int cycle = 0; cycle < 2; ++cycle) {
    const MetricFunction metric = random() % 2 == 0
                                      ? MetricFunction(RandomMetric{&random, h, max_stretch})
                                      : smooth_random_metric(random, h, max_stretch, 4 * h + 0.5);
    const GenerateResult result =
        generate(known.domain, background, sample(background, metric), options);
    REQUIRE(joined(defects_of(known.domain, result, known.area, known.holes)) == "");
    background = result.mesh;
  }
}

/// n x m quadrilaterals with moved corners, each a region of its own, on the square of side 1.
KnownDomain jittered_regions(std::mt19937_64& random, Index n, Index m) {
  KnownDomain known;
  std::vector<Point> corners;
  for (Index j = 0; j <= m; ++j)
    for (Index i = 0; i <= n; ++i) {
      const bool inside = i > 0 && i < n && j > 0 && j < m;
      const double dx = inside ? draw(random, -0.25, 0.25) : 0;
      const double dy = inside ? draw(random, -0.25, 0.25) : 0;
      corners.push_back({(i + dx) / n, (j + dy) / m});
    }
  std::map<std::pair<Index, Index>, Index> lines;
  const auto line = [&](Index a, Index b) {
    const auto [it, is_new] = lines.insert({std::minmax(a, b), 0});
    if (is_new)
      it->second = add_curve(known.domain, "line" + std::to_string(lines.size()),
                             static_cast<Index>(lines.size()), make_line(corners[a], corners[b]));
    return it->second;
  };
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i, b = a + 1, d = a + n + 1, e = d + 1;
      const std::string name = "cell" + std::to_string(j * n + i);
      add_region(known.domain, name, 100 + j * n + i,
                 {line(a, b), line(b, e), line(e, d), line(d, a)}, {});
    }
  known.area = 1;
  return known;
}

/// A star polygon with embedded lines and a circle and required points around its centre.
KnownDomain with_embedded(std::mt19937_64& random) {
  KnownDomain known;
  const std::vector<Point> outer = star_polygon(random, {0, 0}, 1, 9, 0.6);
  add_region(known.domain, "star", 3, add_polygon(known.domain, outer, "side", 1), {});
  known.area = polygon_area(outer);
  auto& embedded = known.domain.regions[0].embedded_curves;
  for (int k = 0; k < 3; ++k) {
    const double y = -0.15 + 0.06 * k;
    embedded.push_back(add_curve(known.domain, "slit" + std::to_string(k), 50 + k,
                                 make_line({draw(random, -0.15, -0.01), y + draw(random, 0, 0.02)},
                                           {draw(random, 0.01, 0.15), y + draw(random, 0, 0.02)})));
  }
  embedded.push_back(add_curve(known.domain, "ring", 60, make_circle({0, 0.13}, 0.05)));
  for (int k = 0; k < 5; ++k)
    known.domain.points.push_back(
        {"point" + std::to_string(k), 70 + k, {draw(random, -0.2, 0.2), draw(random, -0.2, 0.2)}});
  known.domain.points.push_back({"foot", 80, lerp(outer[0], outer[1], draw(random, 0.1, 0.9))});
  return known;
}

GenerateOptions alternating(int i) {
  return generate_options(i % 4 == 3 ? Preset::paper : Preset::best);
}

}  // namespace

TEST_SUITE("property") {
  TEST_CASE("star polygons with holes under any metric up to 1 to 1000 are meshed exactly") {
    for (unsigned seed = 0; seed < 60; ++seed) {
      CAPTURE(seed);
      std::mt19937_64 random(seed);
      const KnownDomain known = star_domain(random);
      check_two_cycles(known, random, draw(random, 0.08, 0.3), std::pow(1000, seed % 4 / 3.),
                       alternating(static_cast<int>(seed / 4)));
    }
  }

  TEST_CASE("metrics that jump from vertex to vertex leave no overlap") {
    // Seeds that failed: 30, 229, 427 where the search box did not cover the corrected trial point
    // (front over itself), 81 where trials of repair were not undone completely (crash).
    for (const unsigned seed : {30u, 81u, 229u, 427u}) {
      CAPTURE(seed);
      std::mt19937_64 random(seed);
      const Domain domain = square_domain(1);
      Mesh background = crossed_square(3, 1);
      for (int cycle = 0; cycle < 2; ++cycle) {
        const auto field = sample(background, RandomMetric{&random, 0.1, 1000});
        const GenerateResult result = generate(domain, background, field, {});
        REQUIRE(joined(defects_of(domain, result, 1, 0)) == "");
        background = result.mesh;
      }
    }
  }

  TEST_CASE("the place and the unit of the coordinates do not matter") {
    for (unsigned seed = 0; seed < 12; ++seed) {
      CAPTURE(seed);
      std::mt19937_64 random(seed);
      const double scale = seed % 3 == 0 ? 1e-9 : seed % 3 == 1 ? 1e9 : 1;
      const Point centre = seed % 3 == 2 ? Point{1e4, -1e4} : Point{0, 0};
      const KnownDomain known = star_domain(random, centre, scale);
      Mesh background = grid_over(known.domain, 4);
      const auto field = sample(background, RandomMetric{&random, 0.15 * scale, 300});
      const GenerateResult result = generate(known.domain, background, field, {});
      // Coordinates rounded to 1e-16 of 1e4 leave that much of the area undetermined.
      const double area = seed % 3 == 2 ? check_mesh(result.mesh).area : known.area;
      CHECK(area == doctest::Approx(known.area).epsilon(1e-10));
      CHECK(joined(defects_of(known.domain, result, area, known.holes)) == "");
    }
  }

  TEST_CASE("several regions with shared interfaces keep their tags under any metric") {
    for (unsigned seed = 0; seed < 16; ++seed) {
      CAPTURE(seed);
      std::mt19937_64 random(seed);
      const KnownDomain known = jittered_regions(random, 1 + static_cast<Index>(random() % 4),
                                                 1 + static_cast<Index>(random() % 4));
      check_two_cycles(known, random, draw(random, 0.05, 0.3), 1000,
                       alternating(static_cast<int>(seed)));
    }
  }

  TEST_CASE("embedded curves and points survive any metric") {
    for (unsigned seed = 0; seed < 16; ++seed) {
      CAPTURE(seed);
      std::mt19937_64 random(seed);
      check_two_cycles(with_embedded(random), random, draw(random, 0.08, 0.3), 1000,
                       alternating(static_cast<int>(seed)));
    }
  }

  TEST_CASE("boundaries far finer than the metric are kept") {
    for (unsigned seed = 0; seed < 10; ++seed) {
      CAPTURE(seed);
      std::mt19937_64 random(seed);
      KnownDomain known;
      const int corners = 40 + 30 * static_cast<int>(seed);
      const std::vector<Point> outer = star_polygon(random, {0, 0}, 1, corners, 0.7);
      add_region(known.domain, "star", 3, add_polygon(known.domain, outer, "side", 1), {});
      known.area = polygon_area(outer);
      check_two_cycles(known, random, draw(random, 0.1, 3), 1000,
                       alternating(static_cast<int>(seed)));
    }
  }

  TEST_CASE("angles below one degree are meshed") {
    for (unsigned seed = 0; seed < 20; ++seed) {
      CAPTURE(seed);
      std::mt19937_64 random(seed);
      const double height = std::pow(10, -1 - 0.2 * seed);
      KnownDomain known;
      const std::vector<Point> spindle{
          {-0.2, 0}, {draw(random, 0.1, 0.6), -height}, {1.2, 0}, {draw(random, 0.2, 0.8), height}};
      add_region(known.domain, "spindle", 3, add_polygon(known.domain, spindle, "side", 1), {});
      known.area = polygon_area(spindle);
      check_two_cycles(known, random, draw(random, 0.05, 0.3), 100, {});
    }
  }

  TEST_CASE("circles that nearly touch are meshed with their vertices on the curves") {
    for (unsigned seed = 0; seed < 16; ++seed) {
      CAPTURE(seed);
      std::mt19937_64 random(seed);
      const double gap = std::pow(10, draw(random, -5, -1));
      KnownDomain known;
      add_curve(known.domain, "outer", 1, make_circle({0, 0}, 1));
      std::vector<std::vector<Index>> holes;
      double x = -1 + gap;
      for (int k = 0; k < 2; ++k) {
        const double radius = draw(random, 0.1, 0.3);
        holes.push_back({add_curve(known.domain, "hole" + std::to_string(k), 2,
                                   make_circle({x + radius, 0}, radius))});
        x += 2 * radius + gap;
      }
      add_region(known.domain, "disc", 3, {0}, holes);
      known.area = -1;
      known.holes = 2;
      check_two_cycles(known, random, draw(random, 0.08, 0.4), 300,
                       alternating(static_cast<int>(seed)));
    }
  }
}
