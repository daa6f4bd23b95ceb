#include <cmath>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "mesher/mesh/boundary_domain.hpp"
#include "tests/mesher/mesh/sample_meshes.hpp"

using namespace anisofront;
using samples::crossed_square;
using samples::ring;

TEST_SUITE("unit") {
  TEST_CASE("edges of a square are attached to its sides by name") {
    Mesh mesh = crossed_square();
    Domain domain;
    domain.curves = {{"south", 11, make_line({0, 0}, {2, 0})},
                     {"east", 12, make_line({2, 0}, {2, 2})}};
    mesh.groups = {{1, 1, "east"}, {1, 2, "south"}};
    mesh.edges = {{{2, 5}, 1, 0, {}}, {{8, 5}, 1, 0, {}}, {{0, 1}, 2, 0, {}}};
    attach_to_domain(mesh, domain);
    CHECK(mesh.edges[0].curve == 1);
    CHECK(mesh.edges[0].parameters == std::array<double, 2>{0, 0.5});
    CHECK(mesh.edges[1].parameters == std::array<double, 2>{1, 0.5});
    CHECK(mesh.edges[2].curve == 0);
    CHECK(mesh.edges[2].tag == 2);
  }

  TEST_CASE("curves that share a tag are told apart by place") {
    Mesh mesh = crossed_square();
    Domain domain;
    domain.curves = {{"wall", 5, make_line({0, 0}, {2, 0})},
                     {"wall-2", 5, make_line({2, 2}, {2, 0})}};
    mesh.groups = {{1, 5, "wall"}};
    mesh.edges = {{{2, 5}, 5, 0, {}}, {{1, 2}, 5, 0, {}}};
    attach_to_domain(mesh, domain);
    CHECK(mesh.edges[0].curve == 1);
    CHECK(mesh.edges[0].parameters == std::array<double, 2>{1, 0.5});
    CHECK(mesh.edges[1].curve == 0);
    CHECK(mesh.edges[1].parameters == std::array<double, 2>{0.5, 1});
  }

  TEST_CASE("an edge whose vertices lie on two curves belongs to the one along it") {
    Mesh mesh;
    mesh.points = {{-1, 0}, {1, 0}, {0, 1}};
    mesh.triangles = {{0, 1, 2}};
    mesh.edges = {{{0, 1}, 0, 0, {}}};
    Domain domain;
    domain.curves = {{"arc", 1, make_arc({0, 0}, 1, 0, std::acos(-1.0))},
                     {"chord", 2, make_line({-1, 0}, {1, 0})}};
    attach_to_domain(mesh, domain);
    CHECK(mesh.edges[0].curve == 1);
    CHECK(mesh.edges[0].tag == 2);
  }

  TEST_CASE("at the seam of a closed curve an edge has the parameter of its own side") {
    Domain domain;
    domain.curves = {{"outer", 1, make_circle({0, 0}, 2)},
                     {"inner", 2, reversed(make_circle({0, 0}, 1))}};
    Mesh mesh = ring(12);
    mesh.points[12] = {2 + 1e-11, -1e-11};  // the seam as a file with 11 digits has it
    attach_to_domain(mesh, domain);
    CHECK(mesh.edges.size() == 24);
    std::array<double, 2> swept{};
    for (const CurveEdge& edge : mesh.edges) {
      const double step = edge.parameters[1] - edge.parameters[0];
      CHECK(std::fabs(step) < 0.5);
      swept[static_cast<std::size_t>(edge.curve)] += step;
      CHECK(edge.tag == edge.curve + 1);
      const NurbsCurve& curve = domain.curves[static_cast<std::size_t>(edge.curve)].curve;
      for (const std::size_t k : {0, 1})
        CHECK(norm(evaluate(curve, edge.parameters[k]) -
                   mesh.points[static_cast<std::size_t>(edge.vertices[k])]) < 1e-10);
    }
    CHECK(swept[0] == doctest::Approx(4).epsilon(1e-14));
    CHECK(swept[1] == doctest::Approx(4).epsilon(1e-14));
  }

  TEST_CASE("without a vertex at the seam of a closed curve one edge crosses it") {
    Domain domain;
    domain.curves = {{"outer", 1, make_circle({0, 0}, 2)},
                     {"inner", 2, make_ellipse({0, 0}, 1, 1, 0.1)}};
    Mesh mesh = ring(12);
    attach_to_domain(mesh, domain);
    std::vector<CurveEdge> crossing;
    for (const CurveEdge& edge : mesh.edges)
      if (crosses_seam(domain.curves[static_cast<std::size_t>(edge.curve)].curve, edge.parameters))
        crossing.push_back(edge);
    REQUIRE(crossing.size() == 1);
    CHECK(crossing[0].curve == 1);
    CHECK(crossing[0].vertices == std::array<Index, 2>{1, 0});
    CHECK(crossing[0].parameters[0] < 0.5);
    CHECK(crossing[0].parameters[1] > 3.5);
  }

  TEST_CASE("an edge over more than half of a closed curve is refused") {
    Mesh mesh;
    mesh.points = {{1, 0}, {std::cos(1.0), std::sin(1.0)}, {std::cos(2.0), std::sin(2.0)}};
    mesh.triangles = {{0, 1, 2}};
    // Nine spans, seven of them between the vertices 3 and 1.
    const NurbsCurve rim = make_polyline(std::vector<Point>{{1, 0},
                                                            mesh.points[1],
                                                            mesh.points[2],
                                                            {-0.1, 0.8},
                                                            {0, 0.7},
                                                            {0.1, 0.6},
                                                            {0.2, 0.5},
                                                            {0.3, 0.4},
                                                            {0.4, 0.3},
                                                            {1, 0}});
    Domain domain;
    domain.curves = {{"rim", 1, rim}};
    CHECK_THROWS_WITH_AS(attach_to_domain(mesh, domain, 1),
                         doctest::Contains("more than half of the closed curve 'rim'"), InputError);
  }

  TEST_CASE("an edge far from the curve of its group is refused with its vertices") {
    Mesh mesh = crossed_square();
    Domain domain;
    domain.curves = {{"south", 1, make_line({0, -0.1}, {2, -0.1})}};
    mesh.groups = {{1, 1, "south"}};
    mesh.edges = {{{0, 1}, 1, 0, {}}};
    CHECK_THROWS_WITH_AS(
        attach_to_domain(mesh, domain),
        doctest::Contains("vertices 1 (0, 0) and 2 (1, 0) of group 'south' is 0.1 away"),
        InputError);
    CHECK_NOTHROW(attach_to_domain(mesh, domain, 0.06));
    CHECK_THROWS_WITH_AS(attach_to_domain(mesh, Domain{}), doctest::Contains("without curves"),
                         InputError);
  }

  TEST_CASE("a mesh attaches to its own domain with the parameters it already has") {
    Mesh mesh = crossed_square();
    const Domain domain = domain_from_mesh(mesh);
    Mesh again = mesh;
    attach_to_domain(again, domain);
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      CHECK(again.edges[e].curve == mesh.edges[e].curve);
      CHECK(again.edges[e].parameters == mesh.edges[e].parameters);
    }
  }
}
