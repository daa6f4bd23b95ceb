#include "adapt/curve_distance.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>

#include "tests/solver/disc_mesh.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

/// By 2000 points on every tagged edge, bent or not.
double sampled_distance(const FeMesh& fe, Point p) {
  double squared = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < fe.mesh.edges.size(); ++i) {
    const Point a = fe.mesh.points[fe.mesh.edges[i].vertices[0]];
    const Point b = fe.mesh.points[fe.mesh.edges[i].vertices[1]];
    const Point m = fe.edge_points[fe.edges.curve_edges[i]];
    for (int k = 0; k <= 2000; ++k) {
      const double t = k / 2000.;
      const Point x = (1 - t) * (1 - 2 * t) * a + 4 * t * (1 - t) * m + t * (2 * t - 1) * b;
      squared = std::min(squared, squared_norm(x - p));
    }
  }
  return std::sqrt(squared);
}

}  // namespace

TEST_SUITE("property") {
  TEST_CASE("distances to bent and straight edges agree with those to many points on them") {
    const Domain domain = disc_domain(1);
    const Mesh mesh = disc_mesh(1, 1);  // six edges only, so that they bend much
    const Mesh square = perturbed_mesh(3, 0.3, 2);
    const FeMesh curved = curved_fe_mesh(mesh, domain), straight = straight_fe_mesh(square);
    Noise noise(4);
    for (const FeMesh* fe : {&curved, &straight}) {
      const std::vector<Index> tags = {kRim, kBottom, kRight, kTop, kLeft};
      const CurveDistance distance(*fe, tags, 3);
      for (int k = 0; k < 200; ++k) {
        const Point p{1.5 * noise(), 1.5 * noise()};
        CAPTURE(p.x);
        CAPTURE(p.y);
        const auto nearest = distance.nearest(p);
        REQUIRE(nearest);
        CHECK(std::abs(nearest->distance - sampled_distance(*fe, p)) < 1e-3);
        CHECK(norm(nearest->tangent) == doctest::Approx(1));
      }
    }
  }
}

TEST_SUITE("unit") {
  TEST_CASE("points beyond the reach have no nearest edge") {
    const Mesh mesh = square_mesh(4);
    const CurveDistance distance(straight_fe_mesh(mesh), {kLeft}, 0.5);
    CHECK(distance.nearest({0.5, 0.3})->distance == doctest::Approx(0.5));
    CHECK_FALSE(distance.nearest({0.5001, 0.3}));
    CHECK_FALSE(distance.nearest({-0.4, -0.4}));
    CHECK(distance.nearest({-0.3, -0.4})->distance == doctest::Approx(0.5));
  }

  TEST_CASE("tangents run along the edges of the mesh") {
    const Mesh mesh = square_mesh(4);
    const CurveDistance distance(straight_fe_mesh(mesh), {kLeft, kTop}, 1);
    CHECK(distance.nearest({0.1, 0.3})->tangent == Vector{0, -1});
    CHECK(distance.nearest({0.4, 0.9})->tangent == Vector{-1, 0});
  }
}
