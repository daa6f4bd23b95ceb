#include "solver/space/fe_mesh.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "solver/space/element_map.hpp"
#include "solver/space/reference_quadrature.hpp"
#include "tests/solver/disc_mesh.hpp"
#include "tests/solver/square_mesh.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

double area_of(const FeMesh& fe) {
  double area = 0;
  for (Index e = 0; e < fe.element_count(); ++e) {
    const Element element = element_at(fe, e);
    for (const auto& [at, weight] : reference_quadrature(element.shape, 6))
      area += weight * map_at(element, at).determinant();
  }
  return area;
}

double length_of(const FeMesh& fe) {
  double length = 0;
  for (Index i = 0; i < static_cast<Index>(fe.mesh.edges.size()); ++i)
    for (const auto& [t, weight] : edge_quadrature(9))
      length += weight * curve_point(fe, i, t).speed;
  return length;
}

template <class M>
constexpr bool kHasStraightView = requires(M&& m) {
  straight_fe_mesh(std::forward<M>(m));
};
template <class M>
constexpr bool kHasCurvedView = requires(M&& m, const Domain& domain) {
  curved_fe_mesh(std::forward<M>(m), domain);
};

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a straight mesh has the midpoints of its edges") {
    const Mesh mesh = mixed_square(3, 2);
    const FeMesh fe = straight_fe_mesh(mesh);
    CHECK(fe.element_count() == 9);
    CHECK(area_of(fe) == doctest::Approx(1));
    CHECK(length_of(fe) == doctest::Approx(4));
    const Element quad = element_at(fe, 8);
    CHECK(quad.shape == Shape::quadrilateral);
    CHECK(quad.region == 1);
    for (int k = 0; k < 4; ++k)
      CHECK(norm(quad.nodes[4 + k] - lerp(quad.nodes[k], quad.nodes[(k + 1) % 4], 0.5)) == 0);
    const MapPoint centre = map_at(quad, {0, 0});
    CHECK(norm(centre.x - quad.nodes[8]) < 1e-15);
  }

  TEST_CASE("bent edges take area and length of a disc to order four") {
    const double pi = std::numbers::pi;
    double error[2];
    for (int k = 0; k < 2; ++k) {
      const Mesh mesh = disc_mesh(2 << k, 1.5);
      const FeMesh fe = curved_fe_mesh(mesh, disc_domain(1.5));
      error[k] = std::abs(area_of(fe) - 2.25 * pi);
      CHECK(length_of(fe) == doctest::Approx(3 * pi).epsilon(2e-4));
    }
    CHECK(error[0] < 1e-2);
    CHECK(std::log2(error[0] / error[1]) == doctest::Approx(4).epsilon(0.03));
  }

  TEST_CASE("edge points and tangents are those of the circle whatever the direction of the edge") {
    Mesh mesh = disc_mesh(3, 2);
    std::swap(mesh.edges[4].vertices[0], mesh.edges[4].vertices[1]);
    std::swap(mesh.edges[4].parameters[0], mesh.edges[4].parameters[1]);
    const FeMesh fe = curved_fe_mesh(mesh, disc_domain(2));
    for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
      CHECK(norm(fe.edge_points[fe.edges.curve_edges[i]]) == doctest::Approx(2).epsilon(1e-12));
      const Point p = mesh.points[mesh.edges[i].vertices[0]];
      const double direction = i == 4 ? -1 : 1;
      CHECK(norm(fe.curve_tangents[i][0] - (direction / 2) * Vector{-p.y, p.x}) < 1e-9);
    }
  }

  TEST_CASE("quadrilaterals bend too") {
    const Mesh mesh = three_quads_of(disc_mesh(4));
    Mesh on_circle = mesh;
    const NurbsCurve circle = make_circle({0, 0}, 1);
    for (CurveEdge& edge : on_circle.edges)
      for (int end = 0; end < 2; ++end)
        on_circle.points[edge.vertices[end]] = evaluate(circle, edge.parameters[end]);
    const FeMesh fe = curved_fe_mesh(on_circle, disc_domain());
    CHECK(area_of(fe) == doctest::Approx(std::numbers::pi).epsilon(1e-5));
  }

  TEST_CASE("an edge over the seam of a closed curve bends outwards") {
    // The mesh is turned by half an edge, so that no vertex lies at the seam.
    Mesh mesh = disc_mesh(2);
    const double turn = std::numbers::pi / 12;
    for (Point& p : mesh.points)
      p = {p.x * std::cos(turn) - p.y * std::sin(turn),
           p.x * std::sin(turn) + p.y * std::cos(turn)};
    const NurbsCurve circle = make_circle({0, 0}, 1);
    for (CurveEdge& edge : mesh.edges)
      for (int end = 0; end < 2; ++end)
        edge.parameters[end] = nearest_point(circle, mesh.points[edge.vertices[end]]).parameter;
    const FeMesh fe = curved_fe_mesh(mesh, disc_domain());
    for (const Index e : fe.edges.curve_edges)
      CHECK(norm(fe.edge_points[e]) == doctest::Approx(1).epsilon(1e-12));
  }

  TEST_CASE("an edge that would turn its element inside out stays straight with a warning") {
    // A hole of radius 1 with one triangle at it, lower than the bulge of its edge.
    Mesh mesh;
    const NurbsCurve circle = make_circle({0, 0}, 1);
    const double t0 = nearest_point(circle, {1, 0.6}).parameter;
    const double t1 = nearest_point(circle, {1, -0.6}).parameter;
    mesh.points = {evaluate(circle, t1), {1.05, 0}, evaluate(circle, t0)};
    mesh.triangles = {{0, 1, 2}};
    CurveEdge edge;
    edge.vertices = {2, 0};
    edge.curve = 0;
    edge.parameters = {t0, t1};
    mesh.edges = {edge};
    std::string warning;
    Monitor monitor;
    monitor.warn = [&](const std::string& text) { warning = text; };
    const FeMesh fe = curved_fe_mesh(mesh, disc_domain(), monitor);
    CHECK(warning.find("stay straight") != std::string::npos);
    CHECK_FALSE(element_at(fe, 0).bent);
    mesh.points[1] = {3, 0};
    CHECK(element_at(curved_fe_mesh(mesh, disc_domain()), 0).bent);
  }

  TEST_CASE("views of temporary meshes do not compile") {
    CHECK(kHasStraightView<Mesh&>);
    CHECK(kHasStraightView<const Mesh&>);
    CHECK_FALSE(kHasStraightView<Mesh>);
    CHECK_FALSE(kHasStraightView<const Mesh>);
    CHECK(kHasCurvedView<const Mesh&>);
    CHECK_FALSE(kHasCurvedView<Mesh>);
    CHECK_FALSE(kHasCurvedView<const Mesh>);
  }

  TEST_CASE("a mesh without elements is refused") {
    const Mesh empty;
    CHECK_THROWS_AS(straight_fe_mesh(empty), InputError);
  }
}
