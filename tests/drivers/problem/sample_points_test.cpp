#include "drivers/problem/sample_points.hpp"

#include <numbers>

#include <doctest/doctest.h>

#include "drivers/problem/element_patch.hpp"
#include "mesher/geometry/error.hpp"
#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// [0, 2] x [0, 1]: two triangles on the left of x = 1, a quadrilateral on the right of it.
Mesh mixed_mesh() {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 4}, {0, 4, 5}};
  mesh.quads = {{1, 2, 3, 4}};
  mesh.triangle_regions = {1, 1};
  mesh.quad_regions = {1};
  return mesh;
}

std::vector<Index> numbers(const std::vector<Location>& places) {
  std::vector<Index> list;
  for (const Location& place : places) list.push_back(place.element.number);
  return list;
}

Domain disc() {
  Domain domain;
  domain.curves.push_back({"rim", 1, make_circle({0, 0}, 2)});
  add_region(domain, "disc", 1, {0}, {});
  return domain;
}

/// Four triangles in the disc, vertices on its circle.
Mesh coarse_disc() {
  Mesh mesh;
  mesh.points = {{0, 0}, {2, 0}, {0, 2}, {-2, 0}, {0, -2}};
  for (Index k = 0; k < 4; ++k) {
    const Index a = k + 1, b = (k + 1) % 4 + 1;
    mesh.triangles.push_back({0, a, b});
    mesh.triangle_regions.push_back(1);
    mesh.edges.push_back({{a, b}, 1, 0, {double(k), double(k + 1)}});
  }
  return mesh;
}

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("a point on an edge or a vertex is found in all elements around it") {
  const Mesh mesh = mixed_mesh();
  const FeMesh fe = straight_fe_mesh(mesh);
  const ElementPatches patches(fe);
  PointLocation location(fe);
  const auto around = [&](Point p) { return patches.around(location.find(p).value()); };
  CHECK(numbers(around({0.25, 0.1})) == std::vector<Index>{0});
  CHECK(numbers(around({0.5, 0.5})) == std::vector<Index>{0, 1});
  CHECK(numbers(around({1, 0.25})) == std::vector<Index>{0, 2});
  CHECK(numbers(around({1, 1})) == std::vector<Index>{0, 1, 2});
  CHECK(numbers(around({1, 0})) == std::vector<Index>{0, 2});
  CHECK(numbers(around({2, 1})) == std::vector<Index>{2});
  CHECK(numbers(around({1.5, 0})) == std::vector<Index>{2});
  for (const Point p : {Point{0.5, 0.5}, {1, 0.25}, {1, 1}, {0, 0}, {1.3, 0.6}})
    for (const Location& place : around(p)) {
      CAPTURE(place.element.number);
      CHECK(norm(map_at(place.element, place.at).x - p) < 1e-14);
    }
}

TEST_CASE("a line on a curve runs in equal steps of arc length with its tangents") {
  const Mesh mesh = coarse_disc();
  const FeMesh fe = straight_fe_mesh(mesh);
  OutputRequests requests;
  requests.lines.push_back({.name = "rim", .curve = "rim", .points = 9});
  const SampleLine line = locate_requests(requests, disc(), fe).lines.at(0);
  REQUIRE(line.places.size() == 9);
  for (int i = 0; i < 9; ++i) {
    const double angle = i * std::numbers::pi / 4;
    const auto k = static_cast<std::size_t>(i);
    CHECK(line.line.lengths[k] == doctest::Approx(2 * angle));
    CHECK(norm(line.line.points[k] - Point{2 * std::cos(angle), 2 * std::sin(angle)}) < 1e-9);
    CHECK(norm(line.line.tangents[k] - Vector{-std::sin(angle), std::cos(angle)}) < 1e-9);
    // At a vertex in the two triangles there, between two in one.
    CHECK(line.places[k].size() == (i % 2 == 0 ? 2u : 1u));
  }
}

TEST_CASE("points between a curve and its chords belong to the mesh and others do not") {
  const Mesh mesh = coarse_disc();
  const FeMesh fe = straight_fe_mesh(mesh);
  OutputRequests requests;
  requests.values.push_back({"near", {1.3, 1.3}, "s.toml:1:1: output.values[0]"});
  CHECK(locate_requests(requests, disc(), fe).values.at(0).places.size() == 1);
  requests.values.push_back({"far", {3, 0}, "s.toml:2:1: output.values[1]"});
  CHECK(message_of<UsageError>([&] { locate_requests(requests, disc(), fe); }) ==
        "s.toml:2:1: output.values[1] \"far\" at (x, y) = (3, 0) lies outside the domain, 1 away "
        "from it");
}

TEST_CASE("of points outside the nearest places are taken where nothing is to be refused") {
  const Mesh mesh = mixed_mesh();
  const FeMesh fe = straight_fe_mesh(mesh);
  const std::vector<Point> points{{3, 0.5}, {0.25, 0.1}, {1, 0.25}};
  const std::vector<Places> places = nearest_places(points, fe);
  REQUIRE(places.size() == 3);
  CHECK(numbers(places[0]) == std::vector<Index>{2});
  CHECK(norm(map_at(places[0][0].element, places[0][0].at).x - Point{2, 0.5}) < 1e-12);
  CHECK(numbers(places[1]) == std::vector<Index>{0});
  CHECK(numbers(places[2]) == std::vector<Index>{0, 2});
}

TEST_SUITE_END();
