#include "adapt/point_location.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/disc_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// How far outside the reference element, 0 inside.
double excess(Shape shape, ReferencePoint at) {
  if (shape == Shape::quadrilateral)
    return std::max({0., std::abs(at.xi) - 1, std::abs(at.eta) - 1});
  return std::max({0., -at.xi, -at.eta, at.xi + at.eta - 1});
}

/// Brute force: is p inside any element by the element's own map?
bool is_in_some_element(const FeMesh& mesh, Point p) {
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    const auto at = inverse_map(element, p);
    if (at && excess(element.shape, *at) < 1e-10) return true;
  }
  return false;
}

void check_against_brute_force(const FeMesh& mesh, Point low, Point high, int count) {
  PointLocation location(mesh);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> x(low.x, high.x), y(low.y, high.y);
  int inside = 0;
  for (int i = 0; i < count; ++i) {
    const Point p{x(random), y(random)};
    CAPTURE(p.x);
    CAPTURE(p.y);
    const auto found = location.find(p);
    REQUIRE(found.has_value() == is_in_some_element(mesh, p));
    if (!found) continue;
    ++inside;
    CHECK(excess(found->element.shape, found->at) == 0);
    CHECK(norm(map_at(found->element, found->at).x - p) < 1e-11);
  }
  CHECK(inside > count / 4);
  CHECK(inside < count);
}

/// Nearest of many points of all elements; not nearer than the true one.
double brute_distance(const FeMesh& mesh, Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Element element = element_at(mesh, e);
    const double low = element.shape == Shape::triangle ? 0 : -1;
    constexpr int kSteps = 60;
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; j <= kSteps; ++j) {
        const ReferencePoint at{low + (1 - low) * i / kSteps, low + (1 - low) * j / kSteps};
        if (excess(element.shape, at) > 1e-12) continue;
        least = std::min(least, norm(map_at(element, at).x - p));
      }
  }
  return least;
}

Mesh stretched_mesh() {
  return mapped(perturbed(mixed_square(7, 9), 7, 9, 0.28, 21), [](Point p) {
    return Point{100 * p.x + 20 * p.y, 0.1 * p.y};
  });
}

/// The ring 1 < r < 2 in quadrilaterals whose edges on the inner circle bend inwards.
Mesh ring_quads(Index n) {
  Mesh mesh = mapped(square_quads(n, 2), [](Point p) {
    const double angle = -2 * std::numbers::pi * p.x, r = 1 + p.y;
    return Point{r * std::cos(angle), r * std::sin(angle)};
  });
  // Join the two ends: vertices of column n are those of column 0.
  for (Quad& q : mesh.quads) {
    for (Index& v : q)
      if (v % (n + 1) == n) v -= n;
  }
  mesh.edges.clear();
  const NurbsCurve circle = make_circle({0, 0}, 1);
  for (Index i = 0; i < n; ++i) {
    const Index a = i, b = i + 1 == n ? 0 : i + 1;
    CurveEdge edge{{a, b}, 1, 0, {}};
    for (int k = 0; k < 2; ++k)
      edge.parameters[k] = nearest_point(circle, mesh.points[edge.vertices[k]]).parameter;
    if (edge.parameters[0] < edge.parameters[1]) edge.parameters[0] = 4;
    mesh.edges.push_back(edge);
  }
  return mesh;
}

}  // namespace

TEST_SUITE("property") {
  TEST_CASE("located points agree with a search through all elements on straight meshes") {
    for (const Mesh& mesh :
         {perturbed_mesh(9, 0.3, 1), perturbed(square_quads(8, 8), 8, 8, 0.28, 2),
          perturbed(mixed_square(8, 8), 8, 8, 0.28, 3), three_quads_of(perturbed_mesh(5, 0.3, 4))})
      check_against_brute_force(straight_fe_mesh(mesh), {-0.3, -0.2}, {1.2, 1.3}, 400);
    const Mesh stretched = stretched_mesh();
    check_against_brute_force(straight_fe_mesh(stretched), {-5, -0.01}, {125, 0.11}, 400);
  }

  TEST_CASE("located points agree with a search through all elements on bent meshes") {
    const Domain domain = disc_domain();
    for (const Mesh& mesh : {disc_mesh(2), disc_mesh(4), disc_quads(2), disc_quads(3)})
      check_against_brute_force(curved_fe_mesh(mesh, domain), {-1.05, -1.05}, {1.05, 1.05}, 800);
  }

  TEST_CASE("the nearest point is no farther than the best of many points of the mesh") {
    const Domain domain = disc_domain();
    const Mesh disc = disc_quads(2), square = perturbed(mixed_square(3, 3), 3, 3, 0.28, 3);
    for (const FeMesh& mesh : {curved_fe_mesh(disc, domain), straight_fe_mesh(square)}) {
      PointLocation location(mesh);
      std::mt19937_64 random(3);
      std::uniform_real_distribution<double> unit(-2, 2);
      for (int i = 0; i < 30; ++i) {
        const Point p{unit(random), unit(random)};
        const Location found = location.nearest(p);
        CHECK(norm(map_at(found.element, found.at).x - p) <= brute_distance(mesh, p) + 1e-12);
      }
    }
  }
}

TEST_SUITE("unit") {
  TEST_CASE("points between the chord and the curve belong to the bent element") {
    const Mesh mesh = disc_mesh(1);
    const FeMesh bent = curved_fe_mesh(mesh, disc_domain()), straight = straight_fe_mesh(mesh);
    // Chords of the hexagon are cos 30 degrees = 0.866 from the centre.
    const Point p{0.93 * std::cos(std::numbers::pi / 6), 0.93 * std::sin(std::numbers::pi / 6)};
    CHECK_FALSE(PointLocation(straight).find(p).has_value());
    const auto found = PointLocation(bent).find(p);
    REQUIRE(found.has_value());
    CHECK(norm(map_at(found->element, found->at).x - p) < 1e-12);
  }

  TEST_CASE("points between the chord and a curve that bends inwards are outside") {
    const Mesh mesh = ring_quads(6);
    const FeMesh bent = curved_fe_mesh(mesh, disc_domain()), straight = straight_fe_mesh(mesh);
    const Point p{0.93 * std::cos(std::numbers::pi / 6), -0.93 * std::sin(std::numbers::pi / 6)};
    CHECK(PointLocation(straight).find(p).has_value());
    CHECK_FALSE(PointLocation(bent).find(p).has_value());
    const Location nearest = PointLocation(bent).nearest(p);
    CHECK(norm(map_at(nearest.element, nearest.at).x) == doctest::Approx(1).epsilon(1e-3));
  }

  TEST_CASE("points outside count as inside within the tolerance") {
    const Mesh mesh = square_mesh(4);
    const FeMesh fe = straight_fe_mesh(mesh);
    PointLocation location(fe);
    CHECK(location.find({1 + 1e-12, 0.3}).has_value());
    CHECK_FALSE(location.find({1 + 1e-6, 0.3}).has_value());
    const auto found = location.find({1 + 1e-6, 0.3}, 1e-5);
    REQUIRE(found.has_value());
    CHECK(norm(map_at(found->element, found->at).x - Point{1, 0.3}) < 1e-14);
    CHECK_FALSE(location.find({1.5, 0.3}, 0.4).has_value());
    CHECK(location.find({1.5, 0.3}, 0.6).has_value());
  }

  TEST_CASE("vertices and edge points are found") {
    const Mesh mesh = disc_quads(3);
    const FeMesh fe = curved_fe_mesh(mesh, disc_domain());
    PointLocation location(fe);
    for (const Point p : mesh.points) CHECK(location.find(p).has_value());
    for (const Point p : fe.edge_points) CHECK(location.find(p).has_value());
  }

  TEST_CASE("coordinates that are not finite are refused") {
    const Mesh mesh = square_mesh(2);
    const FeMesh fe = straight_fe_mesh(mesh);
    PointLocation location(fe);
    CHECK_THROWS_AS(location.nearest({std::nan(""), 0}), InputError);
    CHECK_THROWS_AS(location.find({0, std::numeric_limits<double>::infinity()}), InputError);
  }
}
