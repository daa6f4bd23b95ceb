#include <algorithm>
#include <random>

#include <doctest/doctest.h>

#include "mesher/front/boundary.hpp"
#include "mesher/front/boundary_validity.hpp"
#include "tests/support/work_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

MetricFunction size(double h) {
  return [h](Point) { return metric_from_size(h); };
}

struct Case {
  std::unique_ptr<BackgroundMesh> background;
  Boundary boundary;
};

Case discretise(const Domain& domain, const MetricFunction& metric, BoundaryOptions options) {
  const Mesh grid = crossed_rectangle(12, 12, {-3, -3}, {3, 3});
  Case result;
  result.background = std::make_unique<BackgroundMesh>(grid, sample(grid, metric));
  result.boundary = discretise_boundary(domain, grid, *result.background, options, 100000);
  CHECK(find_conflicts(result.boundary.mesh).empty());
  return result;
}

std::vector<Index> counts(const Domain& domain, const WorkMesh& mesh) {
  std::vector<Index> list(domain.curves.size(), 0);
  for (const Segment& s : mesh.segments) ++list[s.curve];
  return list;
}

/// Numbers of boundary edges of the parts, found by filling the domain with triangles and walking
/// over all of them without crossing a segment.
std::vector<Index> edges_of_parts(Case& work) {
  WorkMesh& mesh = work.boundary.mesh;
  advance_front(*work.background, mesh, {}, 1000);
  std::vector<Index> edges;
  std::vector<char> seen(mesh.triangles.size(), 0);
  for (std::size_t first = 0; first < seen.size(); ++first) {
    if (seen[first]) continue;
    seen[first] = 1;
    edges.push_back(0);
    std::vector<Index> stack{static_cast<Index>(first)};
    while (!stack.empty()) {
      const WorkTriangle t = mesh.triangles[stack.back()];
      stack.pop_back();
      for (const Index n : t.neighbours) {
        if (n < 0) ++edges.back();
        if (n < 0 || seen[n]) continue;
        seen[n] = 1;
        stack.push_back(n);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

bool all_even(const std::vector<Index>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](Index n) { return n % 2 == 0; });
}

/// Edges by region, as the segments say.
std::vector<Index> edges_of_regions(const Domain& domain, const WorkMesh& mesh) {
  std::vector<Index> edges(domain.regions.size(), 0);
  for (const Segment& s : mesh.segments)
    for (const Index region : {s.left_region, s.right_region})
      if (region != kNoIndex) ++edges[region];
  return edges;
}

struct Compared {
  std::vector<Index> plain, even;  ///< edges per curve
};

/// Numbers of edges with and without `even`, with all that holds for every domain checked.
Compared compare(const Domain& domain, const MetricFunction& metric, BoundaryOptions options = {}) {
  const Case plain = discretise(domain, metric, options);
  options.even = true;
  Case even = discretise(domain, metric, options);
  const Compared result{counts(domain, plain.boundary.mesh), counts(domain, even.boundary.mesh)};
  CHECK(all_even(edges_of_regions(domain, even.boundary.mesh)));
  CHECK(all_even(edges_of_parts(even)));
  CHECK(even.boundary.point_vertices.size() == domain.points.size());
  return result;
}

bool within_one(const Compared& compared) {
  for (std::size_t c = 0; c < compared.plain.size(); ++c)
    if (std::abs(compared.plain[c] - compared.even[c]) > 1) return false;
  return true;
}

Domain add_embedded(Domain domain, const NurbsCurve& curve) {
  domain.regions[0].embedded_curves.push_back(
      add_curve(domain, "e" + std::to_string(domain.curves.size()), 9, curve));
  return domain;
}

/// Sides 4.0, 4.4, 4.08 and 5.2 long in the metric of size 0.25: 17 edges by Eqn 19.
const std::vector<Point> kOddQuadrangle{{0, 0}, {1, 0}, {1, 1.1}, {0, 1.3}};

Domain odd_quadrangle() {
  Domain domain;
  add_region(domain, "r", 1, add_polygon(domain, kOddQuadrangle, "s", 1), {});
  return domain;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("an odd boundary changes the side whose ratio N to L suffers least") {
    // 4.4 to 5: ln 1.136 = 0.128; 5.2 to 6: 0.143; 4.08 to 5: 0.204.
    const Compared compared = compare(odd_quadrangle(), size(0.25));
    CHECK(compared.plain == std::vector<Index>{4, 4, 4, 5});
    CHECK(compared.even == std::vector<Index>{4, 5, 4, 5});
  }

  TEST_CASE("an even boundary stays as it is") {
    const Domain domain = square_domain(1);
    for (const double h : {0.3, 0.17, 0.09}) {
      const Compared compared = compare(domain, size(h));
      CHECK(compared.plain == compared.even);
    }
  }

  TEST_CASE("two odd regions change the interface between them") {
    Domain domain;
    const Point p[] = {{0, 0}, {1, 0}, {2, 0}, {2, 1.3}, {1, 1.1}, {0, 1.3}};
    for (Index k = 0; k < 6; ++k)
      add_curve(domain, "c" + std::to_string(k), k + 1, make_line(p[k], p[(k + 1) % 6]));
    const Index interface = add_curve(domain, "interface", 9, make_line(p[1], p[4]));
    add_region(domain, "left", 1, {0, interface, 4, 5}, {});
    add_region(domain, "right", 2, {1, 2, 3, interface}, {});
    const Compared compared = compare(domain, size(0.25));
    CHECK(compared.plain == std::vector<Index>{4, 4, 5, 4, 4, 5, 4});
    CHECK(compared.even == std::vector<Index>{4, 4, 5, 4, 4, 5, 5});
  }

  TEST_CASE("an odd region inside others is led to the outside") {
    // Three discs in each other: only the outermost circle has the outside on one side.
    Domain domain;
    for (const double radius : {0.5, 1., 2.})
      add_curve(domain, "c" + std::to_string(radius), 1, make_circle({0, 0}, radius));
    add_region(domain, "core", 1, {0}, {});
    add_region(domain, "ring", 2, {1}, {{0}});
    add_region(domain, "rim", 3, {2}, {{1}});
    int odd = 0;
    for (int k = 0; k < 12; ++k) {
      const Compared compared = compare(domain, size(0.2 + 0.02 * k));
      CHECK(within_one(compared));
      CHECK(all_even(compared.even));
      odd += all_even(compared.plain) ? 0 : 1;
    }
    CHECK(odd > 6);
  }

  TEST_CASE("only the middle one of three regions in a row is changed when it is odd") {
    Domain domain;
    const Point p[] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1.3, 1.6}, {1, 1}, {0, 1}};
    for (Index k = 0; k < 9; ++k)
      add_curve(domain, "c" + std::to_string(k), k + 1, make_line(p[k], p[(k + 1) % 9]));
    const Index first = add_curve(domain, "i1", 9, make_line(p[1], p[7]));
    const Index second = add_curve(domain, "i2", 9, make_line(p[2], p[5]));
    add_region(domain, "left", 1, {0, first, 7, 8}, {});
    add_region(domain, "middle", 2, {1, second, 5, 6, first}, {});
    add_region(domain, "right", 3, {2, 3, 4, second}, {});
    // The roof of the middle one: 0.922 / 0.25 = 3.69 and 0.671 / 0.25 = 2.68; all other sides 4.
    // 3.69 to 3 costs 0.207, 2.68 to 2 costs 0.293 and 4 to 5 costs 0.223.
    const Compared compared = compare(domain, size(0.25));
    CHECK(compared.plain == std::vector<Index>{4, 4, 4, 4, 4, 4, 3, 4, 4, 4, 4});
    CHECK(compared.even == std::vector<Index>{4, 4, 4, 4, 4, 3, 3, 4, 4, 4, 4});
  }

  TEST_CASE("a hole and its outer boundary may both be odd") {
    Domain domain = odd_quadrangle();
    const std::vector<Point> corners{{0.4, 0.4}, {0.4, 0.62}, {0.62, 0.4}};  // 1, 1 and 1 edges
    const std::vector<Index> hole = add_polygon(domain, corners, "h", 2);
    domain.regions[0].loops.push_back({{hole[0], false}, {hole[1], false}, {hole[2], false}});
    const Compared both = compare(domain, size(0.25));
    CHECK(both.plain == std::vector<Index>{4, 4, 4, 5, 1, 1, 1});
    CHECK(both.even == both.plain);
    Domain square = square_domain(1);
    const Index circle = add_curve(square, "hole", 8, make_circle({0.5, 0.5}, 0.2));
    square.regions[0].loops.push_back({{circle, true}});
    for (const double h : {0.28, 0.25, 0.22, 0.19, 0.16})
      CHECK(within_one(compare(square, size(h))));
  }

  TEST_CASE("a circle has an even number of edges and four at least") {
    Domain domain;
    add_curve(domain, "c", 1, make_circle({0, 0}, 1));
    add_region(domain, "disc", 1, {0}, {});
    for (const double h : {20., 3., 2., 1.3, 1., 0.83, 0.7, 0.61, 0.1}) {
      const Compared compared = compare(domain, size(h));
      CHECK(compared.even[0] % 2 == 0);
      CHECK(compared.even[0] >= 4);
      CHECK(within_one(compared));
    }
  }

  TEST_CASE("an embedded curve that touches nothing has two edges at least and changes no parity") {
    const Domain domain = add_embedded(square_domain(1), make_line({0.4, 0.5}, {0.6, 0.5}));
    CHECK(compare(domain, size(0.25)).even == std::vector<Index>{4, 4, 4, 4, 2});
    const Domain odd = add_embedded(odd_quadrangle(), make_line({0.2, 0.5}, {0.8, 0.5}));
    const Compared compared = compare(odd, size(0.25));  // 2.4: two edges, four sides
    CHECK(compared.even == std::vector<Index>{4, 5, 4, 5, 2});
  }

  TEST_CASE("embedded curves that cut a part off leave even parts on both sides") {
    SUBCASE("from side to side") {
      for (const double y : {0.3, 0.5, 0.71})
        for (const double h : {0.25, 0.21, 0.17, 0.11})
          CHECK(within_one(
              compare(add_embedded(square_domain(1), make_line({0, y}, {1, 0.9 * y})), size(h))));
    }
    SUBCASE("a circle") {
      for (const double h : {0.25, 0.21, 0.17, 0.15, 0.11}) {
        const Compared compared =
            compare(add_embedded(square_domain(1), make_circle({0.5, 0.5}, 0.3)), size(h));
        CHECK(compared.even[4] % 2 == 0);
        CHECK(within_one(compared));
      }
    }
    SUBCASE("a triangle of three lines with a slit inside") {
      const std::vector<Point> p{{0.2, 0.2}, {0.8, 0.3}, {0.4, 0.9}};
      Domain domain = square_domain(1);
      for (int k = 0; k < 3; ++k) domain = add_embedded(domain, make_line(p[k], p[(k + 1) % 3]));
      domain = add_embedded(domain, make_line({0.4, 0.4}, {0.5, 0.5}));
      for (const double h : {0.25, 0.21, 0.17, 0.13, 0.07})
        CHECK(compare(domain, size(h)).even[7] >= 2);
    }
  }

  TEST_CASE("parity outlives refinement for the chord height and against crossings") {
    Domain domain;
    const double gap = 1e-3;
    add_curve(domain, "outer", 1, make_circle({0, 0}, 1));
    add_curve(domain, "inner", 2, make_ellipse({gap, 0}, 1 - 2 * gap, 1 - 2 * gap, 0.17));
    add_region(domain, "ring", 7, {0}, {{1}});
    for (const double h : {0.9, 0.7, 0.6, 0.5}) CHECK(compare(domain, size(h)).even[0] > 20);
    Domain disc;
    add_curve(disc, "c", 1, make_ellipse({0, 0}, 1, 0.3, 0.2));
    add_region(disc, "disc", 1, {0}, {});
    for (const double height : {3e-2, 1e-2, 4e-3, 1e-3}) {
      BoundaryOptions options;
      options.chord_height = height;
      CHECK(compare(disc, size(0.8), options).even[0] % 2 == 0);
    }
  }

  TEST_CASE("required points on curves split them and parity holds all the same") {
    Domain domain = odd_quadrangle();
    domain.points = {{"sensor", 3, {0.313, 0}}, {"inside", 4, {0.5, 0.5}}};
    CHECK(compare(domain, size(0.25)).even.size() == 4);
  }

  TEST_CASE("counts over the old segments become even too") {
    Mesh old;  // the odd quadrangle with one triangle fan
    old.points = kOddQuadrangle;
    old.triangles = {{0, 1, 2}, {0, 2, 3}};
    for (Index k = 0; k < 4; ++k) old.edges.push_back({{k, (k + 1) % 4}, 1, k, {0, 1}});
    BoundaryOptions options;
    options.over_old_segments = true;
    options.even = true;
    const BackgroundMesh background(old, sample(old, size(0.25)));
    const Domain domain = odd_quadrangle();
    const Boundary boundary = discretise_boundary(domain, old, background, options, 1000);
    CHECK(counts(domain, boundary.mesh) == std::vector<Index>{4, 5, 4, 5});
  }
}

TEST_SUITE("property") {
  TEST_CASE("all parts of random polygons with holes and embedded curves become even") {
    std::mt19937_64 random(3);
    for (int i = 0; i < 60; ++i) {
      KnownDomain known = star_domain(random);
      // Inside the disc of radius 0.25 all around, outside of the holes.
      if (i % 2) known.domain = add_embedded(known.domain, make_circle({0, 0}, 0.235));
      if (i % 3) known.domain = add_embedded(known.domain, make_line({0.24, 0}, {0.25, 0.03}));
      const auto metric = smooth_random_metric(random, 0.05 + 0.01 * (i % 10), 10, 2);
      const Compared compared = compare(known.domain, metric);
      for (std::size_t c = 0; c < compared.plain.size(); ++c)
        CHECK(std::abs(compared.plain[c] - compared.even[c]) <= 2);
    }
  }
}
