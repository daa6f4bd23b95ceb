#include "mesher/quads/division.hpp"

#include <algorithm>
#include <cstring>

#include <doctest/doctest.h>

#include "mesher/quads/mixed_quality.hpp"
#include "mesher/quads/mixed_topology.hpp"
#include "tests/support/mixed_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

MetricFunction size(double h) {
  return [h](Point) { return metric_from_size(h); };
}

/// Divides in a constant metric; boundary edges get no segments when there are none.
MixedMesh divided(const MixedMesh& mesh, bool with_pentagons) {
  const auto metric = background(size(1), {-2, -2}, {3, 3});
  return divide_mixed(square_domain(1), *metric, mesh, with_pentagons);
}

/// The unit square and an equilateral triangle on its right side.
MixedMesh house() {
  return mixed_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1.8660254037844386, 0.5}},
                    {triangle(1, 4, 2), quad(0, 1, 2, 3)});
}

double area(const MixedMesh& mesh) { return check_mesh(to_mesh(mesh)).area; }

bool same_bytes(const MixedMesh& x, const MixedMesh& y) {
  const auto equal = [](const auto& a, const auto& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
  };
  return equal(x.vertices, y.vertices) && equal(x.faces, y.faces) && equal(x.segments, y.segments);
}

bool all_quads(const MixedMesh& mesh) { return triangle_count(mesh) == 0; }

/// Faces that are not strictly convex.
int broken_faces(const MixedMesh& mesh) {
  int count = 0;
  for (const MixedFace& f : mesh.faces) count += is_strictly_convex(mesh, f) ? 0 : 1;
  return count;
}

/// A ring of n quadrilaterals between two circles, and its domain.
struct Ring {
  Domain domain;
  MixedMesh mesh;
  Ring(Index n, double inner) {
    add_curve(domain, "outer", 1, make_circle({0, 0}, 1));
    add_curve(domain, "inner", 2, make_circle({0, 0}, inner));
    add_region(domain, "ring", 3, {0}, {{1}});
    std::vector<Point> points;
    for (const Index c : {0, 1})
      for (Index k = 0; k < n; ++k) points.push_back(evaluate(domain.curves[c].curve, 4. * k / n));
    mesh = mixed_mesh(points, {});
    for (Index k = 0; k < n; ++k) {
      const Index l = (k + 1) % n;
      mesh.faces.push_back(quad(k, l, n + l, n + k));
      mesh.segments.push_back({k, l, 0, 4. * k / n, 4. * (k + 1) / n, 0, kNoIndex});
      mesh.segments.push_back({n + k, n + l, 1, 4. * k / n, 4. * (k + 1) / n, kNoIndex, 0});
    }
  }
};

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("triangles make three quadrilaterals and quadrilaterals four and pentagons five") {
    const MixedMesh alone =
        divided(mixed_mesh({{0, 0}, {1, 0}, {0, 1}}, {triangle(0, 1, 2)}), true);
    CHECK(alone.faces.size() == 3);
    CHECK(alone.vertices.size() == 7);
    CHECK(norm(alone.vertices[6].p - Point{1. / 3, 1. / 3}) < 1e-15);
    const MixedMesh square = divided(square_grid(1), true);
    CHECK(square.faces.size() == 4);
    CHECK(square.vertices.size() == 9);
    CHECK(square.vertices[8].p == Point{0.5, 0.5});
    const MixedMesh separate = divided(house(), false);
    CHECK(separate.faces.size() == 7);
    CHECK(separate.vertices.size() == 5 + 6 + 2);
    const MixedMesh pentagon = divided(house(), true);
    CHECK(pentagon.faces.size() == 5);
    CHECK(pentagon.vertices.size() == 5 + 5 + 1);
    for (const MixedMesh& m : {alone, square, separate, pentagon}) {
      CHECK(all_quads(m));
      CHECK(first_defect(m) == "");
    }
    CHECK(area(pentagon) == doctest::Approx(1 + std::sqrt(3.) / 4).epsilon(1e-14));
    CHECK(area(separate) == doctest::Approx(1 + std::sqrt(3.) / 4).epsilon(1e-14));
  }

  TEST_CASE("old vertices keep their numbers and come before midpoints and centres") {
    MixedMesh mesh = house();
    mesh.required[4] = 1;
    const MixedMesh result = divided(mesh, false);
    for (std::size_t v = 0; v < 5; ++v) CHECK(result.vertices[v].p == mesh.vertices[v].p);
    CHECK(norm(result.vertices[5].p - Point{1.4330127018922193, 0.25}) < 1e-15);  // edge 1-4
    CHECK(result.vertices[12].p == Point{0.5, 0.5});  // centre of the square
    CHECK(result.required.size() == result.vertices.size());
    for (std::size_t v = 0; v < result.required.size(); ++v)
      CHECK(result.required[v] == (v == 4 ? 1 : 0));
    CHECK(result.faces[0].vertices == std::array<Index, 4>{1, 5, 11, 7});
  }

  TEST_CASE("segments are halved in place") {
    const MixedMesh mesh = square_grid(3);
    const MixedMesh result = divided(mesh, true);
    REQUIRE(result.segments.size() == 2 * mesh.segments.size());
    for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
      const Segment &old = mesh.segments[s], &a = result.segments[2 * s],
                    &b = result.segments[2 * s + 1];
      CHECK(a.a == old.a);
      CHECK(a.b == b.a);
      CHECK(b.b == old.b);
      CHECK(a.parameter_a == old.parameter_a);
      CHECK(a.parameter_b == b.parameter_a);
      CHECK(b.parameter_b == old.parameter_b);
      CHECK(a.parameter_b ==
            doctest::Approx(0.5 * (old.parameter_a + old.parameter_b)).epsilon(1e-12));
      CHECK(b.left_region == 0);
      CHECK(b.curve == old.curve);
    }
    CHECK(first_defect(result) == "");
    CHECK(area(result) == doctest::Approx(1).epsilon(1e-14));
  }

  TEST_CASE("midpoints on curves lie on them") {
    const Ring ring(6, 0.4);
    const auto metric = background(size(0.5), {-1.1, -1.1}, {1.1, 1.1});
    for (const bool paper : {true, false}) {
      const MixedMesh result = divide_mixed(ring.domain, *metric, ring.mesh, paper);
      CHECK(first_defect(result) == "");
      REQUIRE(result.segments.size() == 24);
      for (const Segment& s : result.segments) {
        CHECK(norm(result.vertices[s.a].p) ==
              doctest::Approx(s.curve == 0 ? 1 : 0.4).epsilon(1e-14));
        CHECK(evaluate(ring.domain.curves[s.curve].curve, s.parameter_b) ==
              (s.parameter_b == 4 ? evaluate(ring.domain.curves[s.curve].curve, 0)
                                  : result.vertices[s.b].p));
      }
      // two regular 12-gons but for the shares that the parameters round off
      CHECK(area(result) == doctest::Approx(3 * (1 - 0.16)).epsilon(2e-3));
    }
  }

  TEST_CASE("a thin ring whose curves bulge more than it is wide stays convex") {
    // The inner midpoint of a hexagon comes up to 0.866 to 1 of the radius.
    const Ring ring(6, 0.8);
    const auto metric = background(size(0.5), {-1.1, -1.1}, {1.1, 1.1});
    const MixedMesh result = divide_mixed(ring.domain, *metric, ring.mesh, false);
    CHECK(broken_faces(result) == 0);
    CHECK(first_defect(result) == "");
  }

  TEST_CASE("where the metric leaves no centre inner edges get arithmetic midpoints") {
    // The bottom bulges up to (2, 0.9); sizes near (0, 1) draw the midpoint of the top to the left
    // until nothing is left of the kernel.
    Domain domain;
    add_curve(domain, "bottom", 1, {2, {0, 0, 0, 1, 1, 1}, {1, 1, 1}, {{0, 0}, {2, 1.8}, {4, 0}}});
    MixedMesh mesh = mixed_mesh({{0, 0}, {4, 0}, {4, 1}, {0, 1}}, {quad(0, 1, 2, 3)});
    mesh.segments.push_back({0, 1, 0, 0, 1, 0, kNoIndex});
    const auto top_midpoint = [&](double least) {
      const auto corner = [least](Point p) {
        return metric_from_size(p.x == 0 && p.y == 1 ? least : 1);
      };
      const auto metric = background(corner, {0, 0}, {4, 1}, 1);
      const MixedMesh result = divide_mixed(domain, *metric, mesh, true);
      CHECK(broken_faces(result) == 0);
      return result.vertices[6].p;
    };
    CHECK(top_midpoint(0.5).x == doctest::Approx(4 * (std::sqrt(0.5) - 0.5) / 0.5).epsilon(1e-2));
    CHECK(top_midpoint(0.01) == Point{2, 1});
  }

  TEST_CASE("the metric of the background is looked up for all vertices") {
    const auto metric =
        background([](Point p) { return metric_from_size(0.2 + 0.3 * p.x); }, {0, 0}, {1, 1});
    const MixedMesh result = divide_mixed(square_domain(1), *metric, square_grid(3), false);
    for (const WorkVertex& v : result.vertices)
      CHECK(1 / v.r.a == doctest::Approx(0.2 + 0.3 * v.p.x).epsilon(1e-9));
  }

  TEST_CASE("the neighbour of least deviation makes the pentagon") {
    // An equilateral triangle 0 1 2 with the unit square at its edge 0-1 (150 degrees) and at 1-2 a
    // trapezoid of angles below 90 degrees.
    const double h = 0.8660254037844386;
    const Vector along{-0.5, h}, out{h, 0.5};
    const Point b{1, 0}, c{0.5, h};
    const MixedMesh result = divided(
        mixed_mesh({{0, 0}, b, c, {0, -1}, {1, -1}, b + out + 0.2 * along, c + out - 0.2 * along},
                   {triangle(0, 1, 2), quad(3, 4, 1, 0), quad(1, 5, 6, 2)}),
        true);
    CHECK(result.faces.size() == 9);
    const auto vertices_at = [&](Point p) {
      return std::count_if(result.vertices.begin(), result.vertices.end(),
                           [p](const WorkVertex& v) { return norm(v.p - p) < 1e-12; });
    };
    CHECK(vertices_at({0.5, 0}) == 1);
    CHECK(vertices_at(0.5 * (b + c)) == 0);
    CHECK(first_defect(result) == "");
  }

  TEST_CASE("a triangle that would make a nearly flat corner is divided alone") {
    // The square has 90 degrees at the origin, the triangle the rest.
    const auto faces = [](Point tip) {
      const MixedMesh result = divided(
          mixed_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}, tip}, {quad(0, 1, 2, 3), triangle(0, 3, 4)}),
          true);
      CHECK(first_defect(result) == "");
      return result.faces.size();
    };
    CHECK(faces({-0.94, 0.34}) == 5);    // 160 degrees
    CHECK(faces({-0.985, 0.174}) == 7);  // 170 degrees
  }

  TEST_CASE("no pentagon crosses a segment or uses a face twice or has a reflex corner") {
    MixedMesh interface = house();
    interface.segments.push_back({1, 2, 0, 0, 1, 0, 1});
    CHECK(divided(interface, true).faces.size() == 7);
    MixedMesh two = house();  // one more triangle on the left of the square
    two.vertices.push_back({{-0.8660254037844386, 0.5}, {}, 0});
    two.required.push_back(0);
    two.faces.push_back(triangle(0, 3, 5));
    CHECK(divided(two, true).faces.size() == 5 + 3);
    MixedMesh flat = house();  // 180 degrees at vertex 1
    flat.vertices[1].p = {1, -0.25};
    flat.vertices[4].p = {3, -0.75};
    CHECK(divided(flat, true).faces.size() == 7);
    CHECK(first_defect(divided(flat, true)) == "");
  }

  TEST_CASE("the result does not depend on the run") {
    std::mt19937_64 random(4);
    const MixedMesh mesh = random_grid(random, 12, 0.2, 0.3);
    CHECK(same_bytes(divided(mesh, true), divided(mesh, true)));
  }

  TEST_CASE("an empty mesh is divided into nothing") {
    CHECK(divided(MixedMesh(), true).faces.empty());
  }
}

TEST_SUITE("property") {
  TEST_CASE("random convex mixed meshes become valid meshes of the same area in any metric") {
    int pentagons = 0;
    for (int seed = 0; seed < 60; ++seed) {
      std::mt19937_64 random(seed);
      MixedMesh mesh = random_grid(random, 8, 0.24, 0.3);
      REQUIRE(broken_faces(mesh) == 0);
      const auto metric =
          background(smooth_random_metric(random, 0.1, 100, 1.5), {0, 0}, {1, 1}, 20);
      const auto triangles = static_cast<std::size_t>(triangle_count(mesh));
      const std::size_t quads = mesh.faces.size() - triangles;
      for (const bool paper : {true, false}) {
        const MixedMesh result = divide_mixed(square_domain(1), *metric, mesh, paper);
        CHECK(all_quads(result));
        CHECK(broken_faces(result) == 0);
        CHECK(first_defect(result) == "");
        CHECK(area(result) == doctest::Approx(1).epsilon(1e-12));
        const std::size_t most = 3 * triangles + 4 * quads;
        CHECK(result.faces.size() <= most);
        if (!paper) CHECK(result.faces.size() == most);
        if (paper) pentagons += static_cast<int>(most - result.faces.size()) / 2;
      }
    }
    CHECK(pentagons > 60);
  }

  TEST_CASE("interfaces inside the mesh stay edges of it") {
    for (int seed = 0; seed < 10; ++seed) {
      std::mt19937_64 random(seed);
      MixedMesh mesh = random_grid(random, 6, 0.2, 0.5);
      for (Index j = 0; j < 6; ++j) {  // the column in the middle, on a curve of its own
        const Index a = 7 * j + 3, b = 7 * (j + 1) + 3;
        mesh.vertices[a].p.x = mesh.vertices[b].p.x = 0.5;
      }
      Domain domain = square_domain(1);
      add_curve(domain, "middle", 9, make_line({0.5, 0}, {0.5, 1}));
      for (Index j = 0; j < 6; ++j) {
        const Index a = 7 * j + 3, b = 7 * (j + 1) + 3;
        mesh.segments.push_back({a, b, 4, mesh.vertices[a].p.y, mesh.vertices[b].p.y, 0, 1});
      }
      if (broken_faces(mesh) > 0) continue;
      const auto metric = background(size(0.2), {0, 0}, {1, 1});
      const MixedMesh result = divide_mixed(domain, *metric, mesh, true);
      CHECK(first_defect(result) == "");  // every curve edge is an edge of the mesh
      for (const MixedFace& f : result.faces) {
        int left = 0, right = 0;
        for (const Index v : f.vertices) {
          left += result.vertices[v].p.x < 0.5 ? 1 : 0;
          right += result.vertices[v].p.x > 0.5 ? 1 : 0;
        }
        CHECK(left * right == 0);
      }
    }
  }
}
