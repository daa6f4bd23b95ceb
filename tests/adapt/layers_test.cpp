#include "adapt/layers.hpp"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/solver/disc_mesh.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Second derivative in the directions a and b.
double along(const Hessian& h, Vector a, Vector b) {
  return a.x * (h.xx * b.x + h.xy * b.y) + a.y * (h.xy * b.x + h.yy * b.y);
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("distances and tangents of a straight side end at the reach") {
    const Mesh mesh = square_mesh(10);
    const LayerFrame frame =
        layer_frame(straight_fe_mesh(mesh), {.tags = {kBottom}, .width = 0.1, .reach = 5.01});
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const double y = mesh.points[v].y;
      CAPTURE(y);
      if (y < 0.55) {
        CHECK(frame.distance[v] == doctest::Approx(y));
        CHECK(frame.tangent[v] == Vector{1, 0});
      } else {
        CHECK(frame.distance[v] == kInfinity);
      }
    }
  }

  TEST_CASE("of several tagged sides the nearest counts") {
    const Mesh mesh = square_mesh(10);
    const LayerFrame frame =
        layer_frame(straight_fe_mesh(mesh), {.tags = {kLeft, kTop}, .width = 0.1, .reach = 100});
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const auto [x, y] = mesh.points[v];
      CHECK(frame.distance[v] == doctest::Approx(std::min(x, 1 - y)));
      if (x < 0.99 - y) CHECK(std::abs(frame.tangent[v].y) == 1);
      if (x > 1.01 - y) CHECK(std::abs(frame.tangent[v].x) == 1);
    }
  }

  TEST_CASE("without tags there is no layer") {
    const Mesh mesh = square_mesh(2);
    for (const double d : layer_frame(straight_fe_mesh(mesh), {}).distance) CHECK(d == kInfinity);
  }

  TEST_CASE("an interface has a layer on both sides") {
    Mesh mesh = square_mesh(8);
    for (Index j = 0; j < 8; ++j) {  // the column x = 1/2
      CurveEdge edge;
      edge.vertices = {9 * j + 4, 9 * j + 13};
      edge.tag = 9;
      mesh.edges.push_back(edge);
    }
    const LayerFrame frame =
        layer_frame(straight_fe_mesh(mesh), {.tags = {9}, .width = 1, .reach = 1});
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      CHECK(frame.distance[v] == doctest::Approx(std::abs(mesh.points[v].x - 0.5)));
      CHECK(frame.tangent[v] == Vector{0, 1});
    }
  }

  TEST_CASE("on a circle distances and tangents are those of the curve and not of the chords") {
    // 48 edges on a circle of radius 2: the chords sag by 4.3e-3, parabolas by some 1e-6.
    const Domain domain = disc_domain(2);
    const Mesh mesh = disc_mesh(8, 2);
    const LayerSettings layers{.tags = {kRim}, .width = 0.1, .reach = 15};
    const LayerFrame frame = layer_frame(curved_fe_mesh(mesh, domain), layers);
    const LayerFrame chords = layer_frame(straight_fe_mesh(mesh), layers);
    double sag = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const double radius = norm(mesh.points[v]), distance = 2 - radius;
      if (distance > 1.4) continue;
      CAPTURE(radius);
      CHECK(frame.distance[v] == doctest::Approx(distance).epsilon(1e-5));
      const Vector tangent = (1 / radius) * Vector{-mesh.points[v].y, mesh.points[v].x};
      CHECK(dot(frame.tangent[v], tangent) > 1 - 1e-6);
      sag = std::max(sag, std::abs(chords.distance[v] - distance));
    }
    CHECK(sag == doctest::Approx(2 * (1 - std::cos(std::numbers::pi / 48))).epsilon(0.2));
  }

  TEST_CASE("alignment keeps the curvatures across and along and drops the mixed one") {
    const Mesh mesh = disc_mesh(6, 1);
    const LayerFrame frame =
        layer_frame(curved_fe_mesh(mesh, disc_domain(1)), {.tags = {kRim}, .width = 0.05});
    const Hessian before{3, -1.5, 0.2};
    FieldHessians fields(2, std::vector<Hessian>(mesh.points.size(), before));
    align_with_layers(frame, 0.4, fields);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const double radius = norm(mesh.points[v]);
      const Hessian& after = fields[1][v];
      if (radius < 0.59) {
        CHECK(after.xy == before.xy);
        continue;
      }
      const Vector n = (1 / radius) * mesh.points[v], s{-n.y, n.x};
      CHECK(along(after, n, n) == doctest::Approx(along(before, n, n)).epsilon(1e-3));
      CHECK(along(after, s, s) == doctest::Approx(along(before, s, s)).epsilon(1e-3));
      CHECK(std::abs(along(after, n, s)) < 1e-3);
    }
  }

  TEST_CASE("the metric of a layer has its sizes across and none beyond the reach") {
    const Mesh mesh = square_mesh(10);
    const LayerSettings layers{.tags = {kLeft}, .width = 0.04, .reach = 10};
    const LayerFrame frame = layer_frame(straight_fe_mesh(mesh), layers);
    const MetricField field = layer_metric(mesh, frame, layers, 0.3);
    const auto size_along_x = [&](Index i) { return 1 / std::sqrt(field[i].m11); };
    CHECK(size_along_x(0) == doctest::Approx(0.02));  // half a width
    CHECK(size_along_x(1) == doctest::Approx(0.05));  // + 0.3 * 0.1
    CHECK(size_along_x(3) == doctest::Approx(0.11));
    CHECK(size_along_x(5) == doctest::Approx(0.3));  // beyond 10 widths
    for (const Metric& m : field) {
      CHECK(m.m22 == doctest::Approx(1 / 0.09));
      CHECK(std::abs(m.m12) < 1e-12);
    }
    CHECK(1 / std::sqrt(layer_metric(mesh, frame, layers, 0.01)[3].m11) == doctest::Approx(0.01));
  }

  TEST_CASE("settings and tags that make no layer are refused by name") {
    const Mesh mesh = square_mesh(2);
    const FeMesh fe = straight_fe_mesh(mesh);
    CHECK_THROWS_WITH_AS(layer_frame(fe, {.tags = {77}, .width = 1}), doctest::Contains("tag 77"),
                         InputError);
    CHECK_THROWS_WITH_AS(layer_frame(fe, {.tags = {kLeft}}), doctest::Contains("width = 0"),
                         InputError);
    FieldHessians fields{{{1, 0, 1}}};
    CHECK_THROWS_AS(align_with_layers(layer_frame(fe, {}), 1, fields), InputError);
  }
}
