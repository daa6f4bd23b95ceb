#include "mesher/mesh/boundary_domain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"
#include "tests/mesher/mesh/sample_meshes.hpp"

using namespace anisofront;
using samples::crossed_square;
using samples::disc;
using samples::ring;

namespace {

constexpr double kPi = std::numbers::pi;

/// Every edge knows its curve and the curve passes its vertices at the parameters, one apart.
void check_edges(const Mesh& mesh, const Domain& domain) {
  for (const CurveEdge& edge : mesh.edges) {
    REQUIRE(edge.curve >= 0);
    const DomainCurve& curve = domain.curves[static_cast<std::size_t>(edge.curve)];
    CHECK(edge.tag == curve.tag);
    CHECK(std::fabs(edge.parameters[1] - edge.parameters[0]) == 1);
    for (const std::size_t k : {0, 1})
      CHECK(norm(evaluate(curve.curve, edge.parameters[k]) -
                 mesh.points[static_cast<std::size_t>(edge.vertices[k])]) < 1e-14);
  }
}

std::vector<std::string> curve_names(const Domain& domain) {
  std::vector<std::string> names;
  for (const DomainCurve& curve : domain.curves) names.push_back(curve.name);
  return names;
}

double total_area(const Domain& domain) {
  double area = 0;
  for (const DomainRegion& region : domain.regions)
    for (const Loop& loop : region.loops) area += signed_area(domain, loop);
  return area;
}

using Strings = std::vector<std::string>;

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a square mesh without edges gets four chains between its corners") {
    Mesh mesh = crossed_square();
    const Domain domain = domain_from_mesh(mesh);
    validate(domain);
    CHECK(curve_names(domain) == Strings{"boundary", "boundary-2", "boundary-3", "boundary-4"});
    for (const DomainCurve& curve : domain.curves) {
      CHECK(curve.tag == 1);
      CHECK(curve.curve.points.size() == 3);
    }
    REQUIRE(domain.regions.size() == 1);
    CHECK(domain.regions[0].tag == 7);
    CHECK(domain.regions[0].loops.size() == 1);
    CHECK(total_area(domain) == 4);
    CHECK(mesh.edges.size() == 8);
    check_edges(mesh, domain);
  }

  TEST_CASE("group names and tags are kept and chains of one group are numbered") {
    Mesh mesh = crossed_square();
    mesh.groups = {{1, 5, "wall"}, {1, 6, "roof"}, {2, 7, "plate"}};
    // roof on the top, wall elsewhere; one edge runs against the boundary.
    mesh.edges = {{{8, 7}, 6, 0, {}}, {{7, 6}, 6, 0, {}}, {{0, 1}, 5, 0, {}}, {{2, 1}, 5, 0, {}},
                  {{2, 5}, 5, 0, {}}, {{5, 8}, 5, 0, {}}, {{6, 3}, 5, 0, {}}, {{3, 0}, 5, 0, {}}};
    const Domain domain = domain_from_mesh(mesh);
    validate(domain);
    CHECK(curve_names(domain) == Strings{"roof", "wall", "wall-2", "wall-3"});
    CHECK(domain.curves[3].tag == 5);
    CHECK(domain.regions[0].name == "plate");
    CHECK(mesh.edges.size() == 8);
    CHECK(mesh.edges[3].vertices == std::array<Index, 2>{1, 2});
    check_edges(mesh, domain);
  }

  TEST_CASE("a change of tag splits a straight side") {
    Mesh mesh = crossed_square();
    mesh.edges = {{{0, 1}, 2, 0, {}}};
    const Domain domain = domain_from_mesh(mesh);
    CHECK(curve_names(domain) ==
          Strings{"curve-2", "boundary", "boundary-2", "boundary-3", "boundary-4"});
    CHECK(domain.curves[0].curve.points.size() == 2);
    CHECK(domain.curves[1].tag == 1);
    check_edges(mesh, domain);
  }

  TEST_CASE("required vertices and corners split a side and required vertices become points") {
    Mesh mesh = crossed_square();
    mesh.required_vertices = {1, 9};
    mesh.corners = {5};
    mesh.groups = {{0, 4, "probe"}};
    mesh.vertex_tags.assign(mesh.points.size(), 0);
    mesh.vertex_tags[10] = 4;
    const Domain domain = domain_from_mesh(mesh);
    validate(domain);
    CHECK(domain.curves.size() == 6);
    REQUIRE(domain.points.size() == 3);
    CHECK(domain.points[0].name == "point");
    CHECK(domain.points[0].point == mesh.points[1]);
    CHECK(domain.points[1].name == "point-2");
    CHECK(domain.points[1].point == Point{0.5, 0.5});
    CHECK(domain.points[2].name == "probe");
    CHECK(domain.points[2].tag == 4);
    CHECK(domain.points[2].point == Point{1.5, 0.5});
  }

  TEST_CASE("a disc has one closed chain") {
    Mesh mesh = disc(16);
    const Domain domain = domain_from_mesh(mesh);
    validate(domain);
    REQUIRE(domain.curves.size() == 1);
    CHECK(is_closed(domain.curves[0].curve));
    CHECK(mesh.edges.size() == 16);
    CHECK(mesh.edges.back().parameters == std::array<double, 2>{15, 16});
    check_edges(mesh, domain);
    // Area of the regular 16-gon.
    CHECK(total_area(domain) == doctest::Approx(8 * std::sin(kPi / 8)).epsilon(1e-14));
  }

  TEST_CASE("a smooth boundary of a disc mesh is nearly its circle also at the seam") {
    Mesh mesh = disc(16);
    const Domain domain = domain_from_mesh(mesh, {.shape = BoundaryShape::smooth});
    validate(domain);
    check_edges(mesh, domain);
    const NurbsCurve& curve = domain.curves[0].curve;
    for (int i = 0; i <= 320; ++i) CHECK(std::fabs(norm(evaluate(curve, i / 20.0)) - 1) < 1e-5);
    CHECK(norm(unit_tangent(curve, 0) - unit_tangent(curve, 16)) < 1e-14);
  }

  TEST_CASE("the corner angle decides what is smooth") {
    Mesh octagon = disc(8);  // turns by 45 degrees
    CHECK(domain_from_mesh(octagon).curves.size() == 8);
    Mesh again = disc(8);
    BoundaryDomainOptions options;
    options.corner_angle = 50;
    CHECK(domain_from_mesh(again, options).curves.size() == 1);
  }

  TEST_CASE("a closed chain with one corner starts there") {
    Mesh mesh = disc(16);
    mesh.points[5] = 1.1 * mesh.points[5];
    mesh.corners = {5};
    const Domain domain = domain_from_mesh(mesh, {.shape = BoundaryShape::smooth});
    REQUIRE(domain.curves.size() == 1);
    const NurbsCurve& curve = domain.curves[0].curve;
    CHECK(curve.points.front() == mesh.points[5]);
    CHECK(norm(unit_tangent(curve, 0) - unit_tangent(curve, 16)) > 0.1);
    check_edges(mesh, domain);
    validate(domain);
  }

  TEST_CASE("a ring of quads has an outer loop and a hole") {
    Mesh mesh = ring(24);
    const Domain domain = domain_from_mesh(mesh);
    validate(domain);
    CHECK(domain.curves.size() == 2);
    REQUIRE(domain.regions[0].loops.size() == 2);
    CHECK(domain.regions[0].tag == 3);
    // 24-gons of radius 2 and 1.
    CHECK(total_area(domain) == doctest::Approx(12 * std::sin(kPi / 12) * 3).epsilon(1e-13));
    check_edges(mesh, domain);
  }

  TEST_CASE("two regions share one interface curve") {
    Mesh mesh = crossed_square();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)  // squares 1 and 3 lie on the right
      mesh.triangle_regions[t] = (t / 4) % 2 == 1 ? 8 : 7;
    mesh.groups = {{2, 7, "steel"}, {2, 8, "copper"}};
    const Domain domain = domain_from_mesh(mesh);
    validate(domain);
    REQUIRE(domain.regions.size() == 2);
    CHECK(domain.regions[0].name == "steel");
    CHECK(domain.regions[1].name == "copper");
    const Index interface = find_curve(domain, "interface");
    REQUIRE(interface != kNoIndex);
    CHECK(domain.curves[static_cast<std::size_t>(interface)].tag == 2);
    for (const DomainRegion& region : domain.regions) {
      CHECK(signed_area(domain, region.loops[0]) == 2);
      CHECK(std::count_if(region.loops[0].begin(), region.loops[0].end(),
                          [&](CurveUse use) { return use.curve == interface; }) == 1);
    }
    CHECK(mesh.edges.size() == 10);
    check_edges(mesh, domain);
  }

  TEST_CASE("an inclusion is a region of its own and a hole of the other") {
    Mesh mesh = disc(16);
    for (int i = 0; i < 16; ++i)
      mesh.points.push_back(2 * mesh.points[static_cast<std::size_t>(i)]);
    for (Index i = 0; i < 16; ++i) {
      const Index next = (i + 1) % 16;
      mesh.quads.push_back({i, 17 + i, 17 + next, next});
    }
    mesh.quad_regions.assign(16, 2);
    const Domain domain = domain_from_mesh(mesh);
    validate(domain);
    CHECK(curve_names(domain) == Strings{"interface", "boundary"});
    REQUIRE(domain.regions.size() == 2);
    CHECK(domain.regions[0].loops.size() == 1);
    CHECK(domain.regions[1].loops.size() == 2);
    CHECK(domain.regions[1].loops[1][0].curve == domain.regions[0].loops[0][0].curve);
    CHECK(domain.regions[1].loops[1][0].reversed != domain.regions[0].loops[0][0].reversed);
  }

  TEST_CASE("parts of one tag that do not share an edge are regions of their own") {
    // Squares 0 and 3 touch at the centre only.
    Mesh mesh = crossed_square();
    mesh.triangles.erase(mesh.triangles.begin() + 4, mesh.triangles.begin() + 12);
    mesh.triangle_regions.resize(8);
    mesh.groups = {{2, 7, "plate"}};
    const Domain domain = domain_from_mesh(mesh);
    validate(domain);
    REQUIRE(domain.regions.size() == 2);
    CHECK(domain.regions[0].name == "plate");
    CHECK(domain.regions[1].name == "plate-2");
    CHECK(domain.regions[1].tag == 7);
    for (const DomainRegion& region : domain.regions)
      CHECK(signed_area(domain, region.loops[0]) == 1);
    CHECK(domain.curves.size() == 8);
  }

  TEST_CASE("a region that touches itself at a vertex is walked along its inside") {
    // A gap from the middle of the bottom side (vertex 1) to the centre: outer boundary and gap
    // meet at vertex 1 only. A notch in the top side besides.
    Mesh mesh = crossed_square();
    mesh.triangles.erase(mesh.triangles.begin() + 14);
    mesh.triangles.erase(mesh.triangles.begin() + 7);
    mesh.triangle_regions.resize(mesh.triangles.size());
    const Domain domain = domain_from_mesh(mesh);
    REQUIRE(domain.regions.size() == 1);
    CHECK(total_area(domain) == 4 - 2 * 0.25);
    REQUIRE(domain.regions[0].loops.size() == 1);  // one loop that passes vertex 1 twice
    const Loop& around = domain.regions[0].loops[0];
    CHECK(std::count_if(around.begin(), around.end(), [&](CurveUse use) {
            return start_point(domain, use) == Point{1, 0};
          }) == 2);
    for (const Loop& loop : domain.regions[0].loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        CHECK(end_point(domain, loop[i]) == start_point(domain, loop[(i + 1) % loop.size()]));
    CHECK(signed_area(domain, domain.regions[0].loops[0]) > 0);
  }

  TEST_CASE("tagged edges inside a region become embedded curves") {
    Mesh mesh = crossed_square();
    mesh.groups = {{1, 9, "rib"}};
    mesh.edges = {{{3, 4}, 9, 0, {}}, {{5, 4}, 9, 0, {}}};  // the second runs against the first
    const Domain domain = domain_from_mesh(mesh);
    validate(domain);
    const Index rib = find_curve(domain, "rib");
    REQUIRE(rib != kNoIndex);
    CHECK(domain.regions[0].embedded_curves == std::vector<Index>{rib});
    CHECK(domain.curves[static_cast<std::size_t>(rib)].curve.points ==
          std::vector<Point>{{0, 1}, {1, 1}, {2, 1}});
    CHECK(mesh.edges[1].parameters == std::array<double, 2>{2, 1});
    CHECK(domain.curves.size() == 7);  // the rib ends split two sides
    check_edges(mesh, domain);
    CHECK(total_area(domain) == 4);
  }

  TEST_CASE("edges listed twice share one place") {
    Mesh mesh = crossed_square();
    mesh.edges = {{{0, 1}, 3, 0, {}}, {{1, 0}, 4, 0, {}}};
    const Domain domain = domain_from_mesh(mesh);
    CHECK(mesh.edges[0].curve == mesh.edges[1].curve);
    CHECK(mesh.edges[1].tag == 3);
    CHECK(mesh.edges.size() == 9);
  }

  TEST_CASE("bad meshes are refused with vertex numbers and coordinates") {
    Mesh mesh = crossed_square();
    mesh.edges = {{{0, 8}, 3, 0, {}}};
    CHECK_THROWS_WITH_AS(
        domain_from_mesh(mesh),
        doctest::Contains("edge from vertex 1 (0, 0) to vertex 9 (2, 2) is no side of any element"),
        InputError);
    mesh = crossed_square();
    mesh.points.push_back({0.5, -1});
    mesh.triangles.push_back({0, 1, 13});  // clockwise
    CHECK_THROWS_WITH_AS(domain_from_mesh(mesh), doctest::Contains("in the same direction"),
                         InputError);
    mesh = crossed_square();
    mesh.triangles.push_back({4, 9, 2});
    CHECK_THROWS_WITH_AS(domain_from_mesh(mesh), doctest::Contains("belongs to 3 elements"),
                         InputError);
    mesh = crossed_square();
    mesh.triangles[2][1] = 99;
    CHECK_THROWS_WITH_AS(domain_from_mesh(mesh), doctest::Contains("element 3"), InputError);
    mesh = crossed_square();
    mesh.required_vertices = {-1};
    CHECK_THROWS_AS(domain_from_mesh(mesh), InputError);
  }
}
