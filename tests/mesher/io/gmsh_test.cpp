#include "mesher/io/gmsh.hpp"

#include <cmath>
#include <map>

#include <doctest/doctest.h>

#include "io_support.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

const std::filesystem::path kGmsh = std::filesystem::path(ANISOFRONT_TEST_DATA) / "gmsh";

const std::vector<std::string> kSuffixes{".22.ascii.msh", ".22.binary.msh", ".41.ascii.msh",
                                         ".41.binary.msh"};

MeshFile parse(const std::string& text, const Monitor& monitor = {}) {
  return parse_gmsh(text, "m.msh", monitor);
}

std::string error_of(const std::string& text) {
  return message_of([&] { parse(text); });
}

/// Format 2.2 with the given nodes and elements, one per line.
std::string msh2(const std::vector<std::string>& nodes, const std::vector<std::string>& elements,
                 const std::string& tail = "") {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  const auto section = [&](const std::string& name, const std::vector<std::string>& lines) {
    text += "$" + name + "\n" + std::to_string(lines.size()) + "\n";
    for (const std::string& line : lines) text += line + "\n";
    text += "$End" + name + "\n";
  };
  section("Nodes", nodes);
  section("Elements", elements);
  return text + tail;
}

const std::vector<std::string> kSquare{"1 0 0 0", "2 1 0 0", "3 1 1 0", "4 0 1 0"};

double edge_length(const Mesh& mesh, const CurveEdge& edge) {
  return norm(mesh.points[edge.vertices[1]] - mesh.points[edge.vertices[0]]);
}

double area(const Mesh& mesh, const Triangle& t) {
  return twice_area(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) / 2;
}

/// Reads the points, lines and triangles of a 2.2 ASCII file line by line, without our library.
Mesh independently_parsed(const std::filesystem::path& path) {
  Mesh mesh;
  std::ifstream in(path);
  std::string line;
  while (std::getline(in, line) && line != "$Nodes") {
  }
  std::size_t n = 0;
  in >> n;
  for (std::size_t i = 0; i < n; ++i) {
    double number = 0, z = 0;
    Point p;
    in >> number >> p.x >> p.y >> z;
    mesh.points.push_back(p);
  }
  in >> line >> line >> n;
  for (std::size_t i = 0; i < n; ++i) {
    Index number = 0, type = 0, tags = 0, physical = 0, elementary = 0, a = 0, b = 0, c = 0;
    in >> number >> type >> tags >> physical >> elementary >> a;
    if (type > 2) continue;
    in >> b;
    if (type == 1) mesh.edges.push_back({{a - 1, b - 1}, physical, elementary, {0, 0}});
    if (type == 1) continue;
    in >> c;
    mesh.triangles.push_back({a - 1, b - 1, c - 1});
    mesh.triangle_regions.push_back(physical);
  }
  return mesh;
}

/// The unit square as one quad in format 2.2 binary with the bytes of every number reversed.
std::string big_endian_square() {
  std::string text = "$MeshFormat\n2.2 1 8\n";
  const auto put = [&text](auto value) {
    char bytes[sizeof(value)];
    std::memcpy(bytes, &value, sizeof(value));
    std::reverse(bytes, bytes + sizeof(value));
    text.append(bytes, sizeof(value));
  };
  put(1);
  text += "\n$EndMeshFormat\n$Nodes\n4\n";
  const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < 4; ++k) {
    put(k + 1);
    for (const double x : {corners[k][0], corners[k][1], 0.0}) put(x);
  }
  text += "\n$EndNodes\n$Elements\n1\n";
  for (const int value : {3, 1, 2, 77, 6, 5, 1, 2, 3, 4}) put(value);
  return text + "\n$EndElements\n";
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("files of the real Gmsh are read exactly in all four flavours") {
    const Mesh expected = independently_parsed(kGmsh / "two-squares.22.ascii.msh");
    REQUIRE(expected.points.size() == 23);
    REQUIRE(expected.triangles.size() == 32);
    for (const std::string& suffix : kSuffixes) {
      CAPTURE(suffix);
      Warnings warnings;
      const Mesh mesh = read_gmsh(kGmsh / ("two-squares" + suffix), warnings.monitor).mesh;
      CHECK(warnings.messages.empty());
      CHECK(mesh.triangles == expected.triangles);
      CHECK(mesh.triangle_regions == expected.triangle_regions);
      CHECK(same_edges(mesh, expected));
      // Gmsh writes 16 digits as text and all bits as binary.
      for (std::size_t v = 0; v < mesh.points.size(); ++v)
        CHECK(norm(mesh.points[v] - expected.points[v]) <= 1e-15);
    }
    for (const char* version : {"22", "41"}) {
      const Mesh ascii =
          read_gmsh(kGmsh / ("two-squares." + std::string(version) + ".ascii.msh")).mesh;
      CHECK(same_bits(coordinates(ascii), coordinates(expected)));
    }
  }

  TEST_CASE("physical names and tags reach points and curves and regions") {
    for (const std::string& suffix : kSuffixes) {
      const Mesh mesh = read_gmsh(kGmsh / ("two-squares" + suffix)).mesh;
      const std::vector<PhysicalGroup> groups{{0, 9, "the corner"},   {1, 10, "outer wall"},
                                              {1, 11, "inner crack"}, {1, 12, "interface"},
                                              {2, 1, "left part"},    {2, 2, "right part"}};
      CHECK(mesh.groups == groups);
      std::map<Index, double> lengths;
      for (const CurveEdge& edge : mesh.edges) lengths[edge.tag] += edge_length(mesh, edge);
      CHECK(lengths.size() == 3);
      CHECK(lengths[10] == doctest::Approx(6));
      CHECK(lengths[11] == doctest::Approx(0.5));
      CHECK(lengths[12] == doctest::Approx(1));
      std::map<Index, double> areas;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        areas[mesh.triangle_regions[t]] += area(mesh, mesh.triangles[t]);
      CHECK(areas.size() == 2);
      CHECK(areas[1] == doctest::Approx(1));
      CHECK(areas[2] == doctest::Approx(1));
      CHECK(mesh.required_vertices == std::vector<Index>{0});
      CHECK(mesh.points[0] == Point{0, 0});
      CHECK(mesh.vertex_tags[0] == 9);
    }
  }

  TEST_CASE("second-order triangles are reduced to their corners with one warning") {
    for (const std::string& suffix : kSuffixes) {
      Warnings warnings;
      const Mesh mesh = read_gmsh(kGmsh / ("second-order" + suffix), warnings.monitor).mesh;
      REQUIRE(warnings.messages.size() == 1);
      CHECK(contains(warnings.messages[0],
                     "18 elements of second order were reduced to their corners"));
      CHECK(mesh.points.size() == 13);
      CHECK(mesh.triangles.size() == 14);
      CHECK(mesh.edges.size() == 4);  // only the arc has a physical group
      double total = 0;
      for (const Triangle& t : mesh.triangles) total += area(mesh, t);
      // Fan of 4 chords of 22.5 degrees under the quarter arc.
      CHECK(total == doctest::Approx(2 * std::sin(std::acos(-1.0) / 8)));
      for (const CurveEdge& edge : mesh.edges)
        CHECK(norm(mesh.points[edge.vertices[0]]) == doctest::Approx(1));
    }
  }

  TEST_CASE("quads of four and eight and nine nodes give the same corners") {
    const Mesh plain = read_gmsh(kGmsh / "quads.41.ascii.msh").mesh;
    CHECK(plain.quads.size() == 11);
    CHECK(plain.triangles.empty());
    CHECK(plain.quad_regions == std::vector<Index>(11, 7));
    for (const char* name :
         {"quads.22.binary.msh", "quads-8.22.ascii.msh", "quads-9.41.binary.msh"}) {
      CAPTURE(name);
      const Mesh mesh = read_gmsh(kGmsh / name).mesh;
      CHECK(mesh.quads.size() == 11);
      CHECK(mesh.points.size() == plain.points.size());
      CHECK(mesh.edges.size() == plain.edges.size());
      CHECK(group_name(mesh, 2, 7) == "quarter");
    }
  }

  TEST_CASE("partitioned files give the mesh without its partition interfaces") {
    for (const char* suffix : {".22.ascii.msh", ".41.ascii.msh", ".41.binary.msh"}) {
      CAPTURE(suffix);
      const Mesh mesh = read_gmsh(kGmsh / ("partitioned" + std::string(suffix))).mesh;
      CHECK(mesh.triangles.size() == 32);
      CHECK(mesh.edges.size() == 16);
      double wall = 0;
      for (const CurveEdge& edge : mesh.edges)
        if (edge.tag == 10) wall += edge_length(mesh, edge);
      CHECK(wall == doctest::Approx(6));
      CHECK(mesh.required_vertices.size() == 1);
    }
  }

  TEST_CASE("node data written by Gmsh is read") {
    for (const char* name : {"node-data.41.ascii.msh", "node-data.41.binary.msh"}) {
      const MeshFile file = read_gmsh(kGmsh / name);
      REQUIRE(file.vertex_fields.size() == 1);
      const FileField& field = file.vertex_fields[0];
      CHECK(field.name == "x plus 2 y");
      CHECK(field.components == 1);
      REQUIRE(field.values.size() == file.mesh.points.size());
      for (std::size_t v = 0; v < field.values.size(); ++v)
        CHECK(field.values[v] ==
              doctest::Approx(file.mesh.points[v].x + 2 * file.mesh.points[v].y));
    }
  }

  TEST_CASE("element-node data written by Gmsh is averaged with a warning") {
    Warnings warnings;
    const MeshFile file = read_gmsh(kGmsh / "element-node-data.22.ascii.msh", warnings.monitor);
    CHECK(warnings.messages.size() == 2);
    REQUIRE(file.element_fields.size() == 1);
    REQUIRE(file.element_fields[0].values.size() == 32);
    for (std::size_t t = 0; t < 32; ++t) {
      Point centre;
      for (const Index v : file.mesh.triangles[t])
        centre = centre + (1.0 / 3) * file.mesh.points[v];
      CHECK(file.element_fields[0].values[t] == doctest::Approx(centre.x + 2 * centre.y));
    }
  }

  TEST_CASE("numbers of the other byte order are swapped") {
    const Mesh mesh = parse(big_endian_square()).mesh;
    CHECK(mesh.points == std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    CHECK(mesh.quads == std::vector<Quad>{{0, 1, 2, 3}});
    CHECK(mesh.quad_regions == std::vector<Index>{6});
  }

  TEST_CASE("clockwise elements are turned round") {
    const Mesh mesh = parse(msh2(kSquare, {"1 2 2 1 1 1 3 2", "2 3 2 1 1 1 4 3 2"})).mesh;
    CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}});
    CHECK(mesh.quads == std::vector<Quad>{{0, 1, 2, 3}});
  }

  TEST_CASE("node numbers may have gaps and any order") {
    const Mesh mesh =
        parse(msh2({"70 1 1 0", "5 0 0 0", "2000000000 7 7 0", "9 1 0 0"}, {"8 2 2 1 1 5 9 70"}))
            .mesh;
    CHECK(mesh.points == std::vector<Point>{{0, 0}, {1, 0}, {1, 1}});
    CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}});
  }

  TEST_CASE("elementary tags take the place of missing physical groups") {
    const Mesh mesh =
        parse(msh2(kSquare, {"1 1 2 0 4 1 2", "2 2 2 0 6 1 2 3", "3 15 2 0 2 1"})).mesh;
    CHECK(mesh.edges[0].tag == 4);
    CHECK(mesh.edges[0].curve == 4);
    CHECK(mesh.triangle_regions == std::vector<Index>{6});
    CHECK(mesh.required_vertices.empty());
    const Mesh named = parse(msh2(kSquare, {"1 1 2 9 4 1 2", "2 2 2 0 6 1 2 3"})).mesh;
    CHECK(named.edges[0].tag == 9);
    CHECK(named.edges[0].curve == 4);
    CHECK(named.triangle_regions == std::vector<Index>{0});
  }

  TEST_CASE("unused nodes are dropped with a warning unless they are tagged points") {
    Warnings warnings;
    const std::string text = msh2({"1 0 0 0", "2 5 5 0", "3 1 0 0", "4 0 1 0", "5 0.2 0.2 0"},
                                  {"1 15 2 3 1 5", "2 2 2 1 1 1 3 4"},
                                  "$NodeData\n1\n\"u\"\n1\n0.5\n3\n2\n1\n5\n"
                                  "1 10\n2 20\n3 30\n4 40\n5 50\n$EndNodeData\n");
    const MeshFile file = parse(text, warnings.monitor);
    CHECK(file.mesh.points == std::vector<Point>{{0, 0}, {1, 0}, {0, 1}, {0.2, 0.2}});
    CHECK(file.mesh.vertex_tags == std::vector<Index>{0, 0, 0, 3});
    CHECK(file.mesh.required_vertices == std::vector<Index>{3});
    REQUIRE(warnings.messages.size() == 1);
    CHECK(warnings.messages[0] ==
          "m.msh: 1 nodes belong to no element and were left out, among them node 2");
    CHECK(file.vertex_fields[0].values == std::vector<double>{10, 30, 40, 50});
    CHECK(file.vertex_fields[0].time == 0.5);
    CHECK(file.vertex_fields[0].step == 2);
  }

  TEST_CASE("an element stored once per physical group is read once") {
    Warnings warnings;
    const Mesh mesh =
        parse(msh2(kSquare, {"1 2 2 1 1 1 2 3", "2 2 2 8 1 2 3 1"}), warnings.monitor).mesh;
    CHECK(mesh.triangles.size() == 1);
    CHECK(mesh.triangle_regions == std::vector<Index>{1});
    REQUIRE(warnings.messages.size() == 2);  // and node 4 is unused
    CHECK(contains(warnings.messages[0], "1 elements repeat the vertices of an earlier one"));
  }

  TEST_CASE("a constant z is dropped and unknown sections are skipped") {
    const std::string text = msh2({"1 0 0 2.5", "2 1 0 2.5", "3 0 1 2.5"}, {"1 2 2 1 1 1 2 3"},
                                  "$Comments\n$Nodes here are words\n$EndComments\n"
                                  "$Periodic\n1\n0 1 2\n1\n1 2\n$EndPeriodic\n");
    CHECK(parse(text).mesh.points == std::vector<Point>{{0, 0}, {1, 0}, {0, 1}});
  }

  TEST_CASE("nodes without an entry in a field get NaN") {
    const MeshFile file =
        parse(msh2(kSquare, {"1 3 2 1 1 1 2 3 4"},
                   "$NodeData\n1\n\"u\"\n1\n0\n3\n0\n1\n1\n2 20\n$EndNodeData\n"));
    CHECK(file.vertex_fields[0].values[1] == 20);
    CHECK(std::isnan(file.vertex_fields[0].values[0]));
  }

  TEST_CASE("the first physical group of a format 4 entity counts") {
    Warnings warnings;
    const std::string text =
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 0\n5 0 0 0 1 1 0 2 8 9 0\n"
        "$EndEntities\n$Nodes\n1 3 1 3\n2 5 1 3\n1\n2\n3\n0 0 0 .5 .5\n1 0 0 .5 .5\n0 1 0 .5 .5\n"
        "$EndNodes\n$Elements\n1 1 1 1\n2 5 2 1\n1 1 2 3\n$EndElements\n";
    const Mesh mesh = parse(text, warnings.monitor).mesh;
    CHECK(mesh.triangle_regions == std::vector<Index>{8});
    CHECK(mesh.points == std::vector<Point>{{0, 0}, {1, 0}, {0, 1}});
    REQUIRE(warnings.messages.size() == 1);
    CHECK(contains(warnings.messages[0], "several physical groups"));
  }

  TEST_CASE("bad Gmsh files are refused with the place and the reason") {
    const auto square = [](const std::string& element) {
      return error_of(msh2(kSquare, {element}));
    };
    CHECK(square("7 2 2 1 1 1 2 9") == "m.msh:13: node number 9 does not exist");
    CHECK(square("7 2 2 1 1 1 2 2") ==
          "m.msh:13: element 7 has no area: its vertices lie on a line");
    CHECK(square("7 1 2 1 1 2 2") == "m.msh:13: element 7 has no length");
    CHECK(contains(square("7 3 2 1 1 1 2 4 3"), "m.msh:13: element 7 crosses itself"));
    CHECK(contains(square("7 4 2 1 1 1 2 3 4"), "element 7 is three-dimensional (type 4)"));
    CHECK(contains(square("7 21 2 1 1 1 2 3"), "element 7 has type 21"));
    CHECK(square("7 2 2 1 x 1 2 3") == "m.msh:13: expected a tag of an element, found 'x'");
    CHECK(square("7 2 2 1 1 1 2") == "m.msh:14: expected a node number, found '$EndElements'");
    CHECK(contains(square("7 2 2 1 1 1 2 3 4"), "m.msh:13: expected $EndElements"));
    CHECK(error_of(msh2({"1 0 0 0", "1 1 0 0"}, {})) == "m.msh:7: node number 1 occurs twice");
    CHECK(error_of(msh2({"1 0 nan 0"}, {})) ==
          "m.msh:6: node 1 has a coordinate that is not finite");
    CHECK(contains(error_of(msh2({"1 0 0 0", "2 1 0 0", "3 0 1 0.5"}, {})),
                   "m.msh:8: node 3 has z = 0.500000"));
    CHECK(error_of("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n") ==
          "m.msh:4: the file has no section $Nodes");
    CHECK(
        contains(error_of("$MeshFormat\n4 0 8\n"), "m.msh:2: Gmsh format 4: expected 2.2 or 4.1"));
    CHECK(contains(error_of("$NOD\n"), "Gmsh format 1"));
    CHECK(error_of("") == "m.msh:1: expected $MeshFormat, found the end of the file");
    CHECK(contains(error_of("$MeshFormat\n2.2 1 8\nabcd"), "byte"));
  }

  TEST_CASE("garbled counts are refused before anything is allocated") {
    const std::string head2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n";
    const std::string head4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n";
    CHECK(contains(error_of(head2 + "999999999999999999\n1 0 0 0\n"), "m.msh:5: "));
    CHECK(contains(error_of(head2 + "-3\n"), "expected at least 0"));
    CHECK(contains(error_of(head4 + "1 999999999999999999 1 2\n"), "is it truncated?"));
    CHECK(contains(error_of(head4 + "1 1 1 1\n2 1 0 999999999999999999\n1\n"), "is it truncated?"));
    CHECK(contains(error_of("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1000000000\n"),
                   "is it truncated?"));
    CHECK(contains(error_of(msh2(kSquare, {}, "$NodeData\n1\n\"u\"\n1\n0\n3\n0\n9\n2000000000\n")),
                   "is it truncated?"));
  }

  TEST_CASE("errors in binary files name the byte") {
    const std::string whole = contents(kGmsh / "two-squares.41.binary.msh");
    const std::string message = error_of(whole.substr(0, whole.size() - 100));
    CHECK(contains(message, "m.msh: byte "));
    CHECK(contains(message, "truncated"));
  }

  TEST_CASE("a missing file is a usage error") {
    try {
      read_gmsh("/nowhere/m.msh");
      FAIL("no error");
    } catch (const UsageError& error) {
      CHECK(contains(error.what(), "/nowhere/m.msh: No such file or directory"));
    }
  }
}
