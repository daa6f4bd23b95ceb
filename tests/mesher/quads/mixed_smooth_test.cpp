#include "mesher/quads/mixed_smooth.hpp"

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

Shape shape_of(const MixedMesh& mesh, FaceQuality quality = shape_quality) {
  Shape shape;
  for (const MixedFace& f : mesh.faces) shape.add(mesh, f, quality);
  return shape;
}

double distance_from_grid(const MixedMesh& mesh, Index n) {
  const MixedMesh grid = square_grid(n);
  double distance = 0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    distance = std::max(distance, norm(mesh.vertices[v].p - grid.vertices[v].p));
  return distance;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a disturbed grid goes back towards squares and its boundary stays") {
    const auto metric = background(size(0.25), {0, 0}, {1, 1});
    std::mt19937_64 random(1);
    MixedMesh mesh = random_grid(random, 4, 0.35, 0);
    look_up_metrics(*metric, mesh);
    const double before = distance_from_grid(mesh, 4);
    REQUIRE(before > 0.08);
    smooth_mixed(*metric, mesh, 3);
    CHECK(distance_from_grid(mesh, 4) < 0.25 * before);
    smooth_mixed(*metric, mesh, 30);
    CHECK(distance_from_grid(mesh, 4) < 0.01);
    const MixedMesh grid = square_grid(4);
    for (const Segment& s : mesh.segments) {
      CHECK(mesh.vertices[s.a].p == grid.vertices[s.a].p);
      CHECK(mesh.vertices[s.b].p == grid.vertices[s.b].p);
    }
  }

  TEST_CASE("a perfect grid does not move") {
    const auto metric = background(size(0.25), {0, 0}, {1, 1});
    MixedMesh mesh = square_grid(4);
    look_up_metrics(*metric, mesh);
    smooth_mixed(*metric, mesh);
    CHECK(distance_from_grid(mesh, 4) == 0);
  }

  TEST_CASE("the ideal place among six triangles is that of equilateral ones") {
    const auto metric = background(size(1), {-2, -2}, {2, 2});
    const double h = 0.8660254037844386;
    MixedMesh mesh =
        mixed_mesh({{1, 0}, {0.5, h}, {-0.5, h}, {-1, 0}, {-0.5, -h}, {0.5, -h}, {0.2, 0.1}}, {});
    for (Index k = 0; k < 6; ++k) {
      mesh.faces.push_back(triangle(k, (k + 1) % 6, 6));
      mesh.segments.push_back({k, (k + 1) % 6, 0, 0, 1, 0, kNoIndex});
    }
    look_up_metrics(*metric, mesh);
    smooth_mixed(*metric, mesh, 1);
    // Eqn 26 names the centre six times, whatever the place before.
    CHECK(norm(mesh.vertices[6].p) < 1e-12);
  }

  TEST_CASE("the ideal place among four squares is their common corner in any constant metric") {
    // x is stretched four times: squares of size 1 by 4 in space
    const auto metric = background(
        [](Point) {
          return metric_from_sizes(1, 4, {0, 1});
        },
        {-8, -2}, {8, 2});
    MixedMesh mesh = mixed_mesh(
        {{-4, -1}, {0, -1}, {4, -1}, {-4, 0}, {0.9, -0.2}, {4, 0}, {-4, 1}, {0, 1}, {4, 1}},
        {quad(0, 1, 4, 3), quad(1, 2, 5, 4), quad(3, 4, 7, 6), quad(4, 5, 8, 7)});
    for (const auto& [a, b] :
         {std::pair{0, 1}, {1, 2}, {2, 5}, {5, 8}, {8, 7}, {7, 6}, {6, 3}, {3, 0}})
      mesh.segments.push_back({a, b, 0, 0, 1, 0, kNoIndex});
    look_up_metrics(*metric, mesh);
    smooth_mixed(*metric, mesh, 1);
    CHECK(norm(mesh.vertices[4].p) < 1e-12);  // Eqn 27: both turned edges end there
  }

  TEST_CASE("required vertices stay where they are") {
    const auto metric = background(size(0.25), {0, 0}, {1, 1});
    MixedMesh mesh = square_grid(4);
    const Index v = 2 * 5 + 2;
    mesh.vertices[v].p = {0.55, 0.45};
    mesh.required[v] = 1;
    look_up_metrics(*metric, mesh);
    smooth_mixed(*metric, mesh);
    search_mixed(*metric, mesh);
    CHECK(mesh.vertices[v].p == Point{0.55, 0.45});
    CHECK(distance_from_grid(mesh, 4) > 0.05);
    mesh.required[v] = 0;
    smooth_mixed(*metric, mesh);
    CHECK(distance_from_grid(mesh, 4) < 0.01);
  }

  TEST_CASE("a vertex that lies outside of its faces is brought back") {
    const auto metric = background(size(0.25), {0, 0}, {1, 1});
    MixedMesh mesh = square_grid(4);
    mesh.vertices[12].p = {0.8, 0.5};  // beyond its right neighbour
    look_up_metrics(*metric, mesh);
    REQUIRE(shape_of(mesh).broken > 0);
    smooth_mixed(*metric, mesh);
    CHECK(shape_of(mesh).broken == 0);
    CHECK(first_defect(mesh) == "");
  }

  TEST_CASE("the search brings the common corner of four squares into their middle") {
    const auto metric = background(size(0.5), {0, 0}, {1, 1});
    MixedMesh mesh = square_grid(2);
    mesh.vertices[4].p = {0.62, 0.41};
    look_up_metrics(*metric, mesh);
    search_mixed(*metric, mesh, 3);
    CHECK(norm(mesh.vertices[4].p - Point{0.5, 0.5}) < 0.01);
  }

  TEST_CASE("moved vertices carry the metric of their new place") {
    const auto metric =
        background([](Point p) { return metric_from_size(0.2 + 0.1 * p.x); }, {0, 0}, {1, 1});
    std::mt19937_64 random(2);
    MixedMesh mesh = random_grid(random, 4, 0.3, 0.3);
    look_up_metrics(*metric, mesh);
    smooth_mixed(*metric, mesh);
    for (const WorkVertex& v : mesh.vertices)
      CHECK(1 / v.r.a == doctest::Approx(0.2 + 0.1 * v.p.x).epsilon(1e-9));
  }
}

TEST_SUITE("property") {
  TEST_CASE("the search goes on where smoothing has come to an end") {
    int better = 0;
    for (int seed = 0; seed < 10; ++seed) {
      std::mt19937_64 random(seed);
      const auto metric = background(smooth_random_metric(random, 0.1, 20, 1.5), {0, 0}, {1, 1});
      MixedMesh mesh = random_grid(random, 8, 0.3, 0.3);
      look_up_metrics(*metric, mesh);
      smooth_mixed(*metric, mesh, 20);
      const Shape before = shape_of(mesh, combined_quality);
      const double shapes_before = shape_of(mesh).product;
      search_mixed(*metric, mesh, 2);
      const Shape after = shape_of(mesh, combined_quality);
      CHECK(after.broken <= before.broken);
      if (before.broken == 0) CHECK(after.product > before.product);
      if (before.broken == 0) CHECK(first_defect(mesh) == "");
      better += shape_of(mesh).product > shapes_before ? 1 : 0;
    }
    CHECK(better >= 8);
  }

  TEST_CASE("smoothing raises the product of the qualities and keeps meshes valid") {
    for (int seed = 0; seed < 20; ++seed) {
      std::mt19937_64 random(seed);
      const auto metric = background(smooth_random_metric(random, 0.1, 20, 1.5), {0, 0}, {1, 1});
      MixedMesh mesh = random_grid(random, 8, 0.3, 0.3);
      look_up_metrics(*metric, mesh);
      const Shape before = shape_of(mesh);
      smooth_mixed(*metric, mesh);
      const Shape after = shape_of(mesh);
      CHECK(after.broken <= before.broken);
      if (before.broken == 0) CHECK(after.product > before.product);
      if (before.broken == 0) CHECK(first_defect(mesh) == "");
    }
  }
}
