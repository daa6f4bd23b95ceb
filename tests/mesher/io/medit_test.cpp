#include "mesher/io/medit.hpp"

#include <limits>

#include <doctest/doctest.h>

#include "io_support.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

const std::string kHead = "MeshVersionFormatted 2\nDimension 2\n";
const std::string kVertices = "Vertices\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

Mesh parse(const std::string& text, const Monitor& monitor = {}) {
  return parse_medit(text, "m.mesh", monitor);
}

std::string error_of(const std::string& text) {
  return message_of([&] { parse(text); });
}

MetricField metric(const std::string& entries, Index vertices = 2) {
  return parse_medit_metric(kHead + "SolAtVertices\n" + entries + "\nEnd\n", "m.sol", vertices);
}

std::string metric_error(const std::string& entries) {
  return message_of([&] { metric(entries); });
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("every section of a Medit mesh is read") {
    Warnings warnings;
    const Mesh mesh = parse(
        "# made by hand\nMeshVersionFormatted\n1\n\nDimension\n2\n"
        "Vertices # four of them\n5\n0 0 7\n1 0 0\n1 1 0\n0 1 -3\n2.5e0 +1 0\n"
        "Edges\n2\n1 2 5\n2 5 6\nTriangles\n1\n1 2 3 8\nQuadrilaterals\n1\n1 2 5 4 9\n"
        "Corners\n2\n1\n3\nRequiredVertices\n1\n4\nRidges\n1\n2\nEnd\n",
        warnings.monitor);
    CHECK(warnings.messages.empty());
    CHECK(mesh.points == std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2.5, 1}});
    CHECK(mesh.vertex_tags == std::vector<Index>{7, 0, 0, -3, 0});
    REQUIRE(mesh.edges.size() == 2);
    CHECK(mesh.edges[1].vertices == std::array<Index, 2>{1, 4});
    CHECK(mesh.edges[1].tag == 6);
    CHECK(mesh.edges[1].curve == kNoIndex);
    CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}});
    CHECK(mesh.triangle_regions == std::vector<Index>{8});
    CHECK(mesh.quads == std::vector<Quad>{{0, 1, 4, 3}});
    CHECK(mesh.quad_regions == std::vector<Index>{9});
    CHECK(mesh.corners == std::vector<Index>{0, 2});
    CHECK(mesh.required_vertices == std::vector<Index>{3});
  }

  TEST_CASE("sections may come in any order and elements in any direction") {
    const Mesh mesh = parse(kHead + "Triangles\n1\n1 3 2 0\nQuadrilaterals\n1\n2 1 4 3 0\n" +
                            kVertices + "End\n");
    CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}});
    CHECK(mesh.quads == std::vector<Quad>{{1, 2, 3, 0}});
    CHECK(mesh.vertex_tags.empty());
  }

  TEST_CASE("three dimensions with a constant z are accepted") {
    const std::string head = "MeshVersionFormatted 2\nDimension 3\nVertices\n3\n";
    const std::string tail = "Triangles\n1\n1 2 3 0\nTetrahedra\n0\nEnd\n";
    CHECK(parse(head + "0 0 4 0\n1 0 4 0\n0 1 4 0\n" + tail).points.size() == 3);
    CHECK(contains(error_of(head + "0 0 4 0\n1 0 5 0\n0 1 4 0\n" + tail),
                   "m.mesh:6: z varies at vertex 2"));
  }

  TEST_CASE("what is lost or suspicious is warned of") {
    Warnings warnings;
    parse(kHead + kVertices + "RequiredEdges\n1\n1\n", warnings.monitor);
    REQUIRE(warnings.messages.size() == 2);
    CHECK(contains(warnings.messages[0], "RequiredEdges is not kept"));
    CHECK(contains(warnings.messages[1], "no End"));
  }

  TEST_CASE("a Medit mesh survives a round trip bit by bit") {
    const Scratch scratch;
    Mesh mesh = small_file().mesh;
    mesh.points[0] = {-0.0, 4.9406564584124654e-324};
    mesh.points[5] = {1e308, 1.0 / 3};
    mesh.quads.clear();  // its products overflow
    mesh.quad_regions.clear();
    mesh.vertex_tags = {0, 0, -2, 0, 0, 2147483647};
    mesh.corners = {1, 0};
    mesh.required_vertices = {5};
    write_medit(scratch / "m.mesh", mesh);
    mesh.groups.clear();
    for (CurveEdge& edge : mesh.edges) edge.curve = kNoIndex;
    CHECK(differences(read_medit(scratch / "m.mesh"), mesh) == "");
  }

  TEST_CASE("bad Medit meshes are refused with the line and the reason") {
    const auto section = [](const std::string& text) { return error_of(kHead + kVertices + text); };
    CHECK(error_of("") == "m.mesh:1: expected MeshVersionFormatted, found the end of the file");
    CHECK(contains(error_of("MeshVersionFormatted 2\nDimension 4\n"), "m.mesh:2: wrong dimension"));
    CHECK(error_of(kHead + "Vertices\n2\n0 0 0\n1 x 0\n") ==
          "m.mesh:6: expected the finite coordinate y, found 'x'");
    CHECK(error_of(kHead + "Vertices\n2\n0 0 0\n1 inf 0\n") ==
          "m.mesh:6: expected the finite coordinate y, found 'inf'");
    CHECK(contains(error_of(kHead + "Vertices\n999999999999999999\n0 0 0\n"), "m.mesh:4: "));
    CHECK(contains(error_of(kHead + "Vertices\n9999999999999999999\n0 0 0\n"),
                   "m.mesh:4: expected the number of vertices, found '9999999999999999999'"));
    CHECK(contains(error_of(kHead + "Vertices\n-1\n"), "expected the number of vertices"));
    CHECK(contains(section("Vertices\n1\n0 0 0\n"), "m.mesh:9: a second section Vertices"));
    CHECK(section("Triangles\n2\n1 2 3 0\n1 2 5 0\nEnd\n") ==
          "m.mesh:12: triangle 2: vertex number 5, expected 1 to 4");
    CHECK(section("Triangles\n1\n0 2 3 0\nEnd\n") ==
          "m.mesh:11: triangle 1: vertex number 0, expected 1 to 4");
    CHECK(section("Triangles\n1\n1 2 2 0\nEnd\n") ==
          "m.mesh:11: triangle 1 has no area: its vertices lie on a line");
    CHECK(contains(section("Quadrilaterals\n1\n1 2 4 3 0\nEnd\n"),
                   "m.mesh:11: quadrilateral 1 crosses itself"));
    CHECK(section("Edges\n1\n2 2 0\nEnd\n") == "m.mesh:11: edge 1 has no length");
    CHECK(section("Corners\n2\n1\n9\nEnd\n") == "m.mesh:12: vertex number 9, expected 1 to 4");
    CHECK(contains(section("Triangles\n3\n1 2 3 0\n1 3 4 0"),
                   "m.mesh:10: the number of elements is 3, but the file ends"));
    CHECK(contains(section("Triangles\n1\n1 2 3.5 0\n"), "found '3.5'"));
    CHECK(contains(section("Tetrahedra\n1\n1 2 3 4 0\n"), "Tetrahedra is three-dimensional"));
  }

  TEST_CASE("tensors and sizes are read as metrics") {
    CHECK(metric("2\n1 3\n2 1 3\n4 0 5") == MetricField{{2, 1, 3}, {4, 0, 5}});
    CHECK(metric("2\n1 1\n0.5\n0.25") == MetricField{{4, 0, 4}, {16, 0, 16}});
  }

  TEST_CASE("bad metrics are refused with the line and the vertex") {
    CHECK(contains(metric_error("2\n1 3\n2 1 3\n1 2 1"), "m.sol:7: vertex 2: the metric"));
    CHECK(contains(metric_error("2\n1 3\n2 1 3\n1 2 1"), "is not positive definite"));
    CHECK(contains(metric_error("2\n1 3\n2 1 3\n1 nan 1"), "m.sol:7: vertex 2"));
    CHECK(contains(metric_error("2\n1 3\n2 1 3\n1 nan 1"), "is not finite"));
    CHECK(contains(metric_error("2\n1 1\n0\n1"),
                   "m.sol:6: vertex 1: the size 0.000000 is not positive"));
    CHECK(contains(metric_error("2\n1 1\n1e-200\n1"), "too small"));
    CHECK(contains(metric_error("3\n1 1\n1\n1\n1"), "metrics of 3 vertices, but the mesh has 2"));
    CHECK(contains(metric_error("2\n1 2\n1 1\n1 1"), "found type 2"));
    CHECK(contains(metric_error("2\n2 1 1\n1 1\n1 1"), "expected one field"));
    CHECK(contains(metric_error("2\n1 3\n2 1 3\n1"), "m.sol:8: expected a number of the metric"));
    CHECK(message_of([] { parse_medit_metric(kHead + "SolAtVertices 1 1 3 2 1", "m.sol", 1); }) ==
          "m.sol:3: vertex 1: its metric is missing, the file ends here");
    // Positive definite although the determinant would underflow.
    CHECK(metric("1\n1 3\n1e-200 0 1e-200", 1) == MetricField{{1e-200, 0, 1e-200}});
  }

  TEST_CASE("metrics survive a round trip bit by bit") {
    const Scratch scratch;
    const MetricField field{{1.0 / 3, -0.0, 1e300}, {4.9e-324, 0, 1}, {0.1, 0.01, 0.3}};
    write_medit_metric(scratch / "m.sol", field);
    CHECK(read_medit_metric(scratch / "m.sol", 3) == field);
    CHECK(contains(contents(scratch / "m.sol"), "\n0.3333333333333333 -0 1e+300\n"));
  }
}
