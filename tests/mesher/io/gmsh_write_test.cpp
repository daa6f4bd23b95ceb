#include <bit>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "io_support.hpp"

using namespace anisofront;
using namespace anisofront::test;

namespace {

MeshFile round_trip(const MeshFile& file, GmshFormat format) {
  const Scratch scratch;
  write_gmsh(scratch / "m.msh", file, format);
  return read_gmsh(scratch / "m.msh");
}

/// Any bits that make a finite double.
double random_double(std::mt19937_64& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) return value;
  }
}

/// Everything a MeshFile can hold; elements, edges and vertices of several entities in turn, so
/// that grouping by entity (format 4.1) has an order to restore.
MeshFile full_file(unsigned seed) {
  std::mt19937_64 random(seed);
  MeshFile file;
  Mesh& mesh = file.mesh;
  const auto coordinate = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
  for (Index k = 0; k < 20; ++k) {
    const double x = 3.0 * k;
    const Index v = 4 * k;
    mesh.points.insert(mesh.points.end(), {{x + coordinate(), coordinate()},
                                           {x + 1 + coordinate(), 0.0},
                                           {x + 1 + coordinate(), 1 + coordinate()},
                                           {x - coordinate(), 1 + coordinate()}});
    if (k % 2 == 0) {
      mesh.triangles.insert(mesh.triangles.end(), {{v, v + 1, v + 2}, {v, v + 2, v + 3}});
      mesh.triangle_regions.insert(mesh.triangle_regions.end(), {7 * (k % 3), 5});
    } else {
      mesh.quads.push_back({v, v + 1, v + 2, v + 3});
      mesh.quad_regions.push_back(k % 3);
    }
    mesh.edges.push_back({{v, v + 1}, k % 4, k % 5 - 1, {random_double(random), -0.0}});
  }
  mesh.vertex_tags.assign(mesh.points.size(), 0);
  mesh.vertex_tags[8] = 3;
  mesh.vertex_tags[2] = 9;
  mesh.corners = {9, 4};
  mesh.required_vertices = {2, 17};
  mesh.groups = {{2, 7, "a name with blanks"}, {1, 1, "Größe #1"}, {0, 3, ""}};
  for (const int components : {1, 3, 9}) {
    FileField field{"f" + std::to_string(components), components, {}, random_double(random), 4};
    for (std::size_t i = 0; i < mesh.points.size() * static_cast<std::size_t>(components); ++i)
      field.values.push_back(random_double(random));
    file.vertex_fields.push_back(field);
    field.values.resize((mesh.triangles.size() + mesh.quads.size()) *
                        static_cast<std::size_t>(components));
    file.element_fields.push_back(field);
  }
  return file;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("a small mesh with names and regions survives all four Gmsh flavours") {
    for (const GmshFormat format : kFlavours)
      CHECK(differences(round_trip(small_file(), format), small_file()) == "");
  }

  TEST_CASE("a mesh without any tag comes back without tags") {
    MeshFile file = small_file();
    file.mesh.triangle_regions = {0, 0};
    file.mesh.quad_regions = {0};
    for (CurveEdge& edge : file.mesh.edges) edge = {edge.vertices, 0, kNoIndex, {0, 0}};
    file.mesh.groups.clear();
    for (const GmshFormat format : kFlavours)
      CHECK(differences(round_trip(file, format), file) == "");
  }

  TEST_CASE("the empty mesh survives") {
    for (const GmshFormat format : kFlavours)
      CHECK(differences(round_trip(MeshFile{}, format), MeshFile{}) == "");
  }

  TEST_CASE("extreme coordinates come back bit by bit") {
    constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
    MeshFile file;
    // Thin but not degenerate: no product of the orientation test over- or underflows.
    file.mesh.points = {{-0.0, 0.0}, {1e308, -0.0}, {0, kSmallest}, {0.1, 1.0 / 3}};
    file.mesh.triangles = {{0, 1, 2}};
    file.mesh.triangle_regions = {1};
    file.mesh.vertex_tags = {0, 0, 0, 8};  // vertex 3 stays although no triangle uses it
    file.mesh.required_vertices = {3};
    for (const GmshFormat format : kFlavours)
      CHECK(differences(round_trip(file, format), file) == "");
  }

  TEST_CASE("numbers in ASCII files are the shortest exact decimals") {
    const Scratch scratch;
    MeshFile file = small_file();
    file.mesh.points[0] = {-0.1, 0.30000000000000004};
    write_gmsh(scratch / "m.msh", file, {GmshVersion::v2_2, false});
    CHECK(contains(contents(scratch / "m.msh"), "\n1 -0.1 0.30000000000000004 0 \n"));
  }

  TEST_CASE("elements are numbered edges first then triangles then quads then points") {
    const Scratch scratch;
    MeshFile file = small_file();
    file.mesh.vertex_tags = {0, 0, 0, 4, 0, 0};
    file.mesh.required_vertices = {3};
    write_gmsh(scratch / "m.msh", file, {GmshVersion::v2_2, false});
    CHECK(contains(contents(scratch / "m.msh"),
                   "$Elements\n7\n1 1 2 10 3 1 2 \n2 1 2 10 3 2 5 \n3 1 2 11 5 4 1 \n"
                   "4 2 2 1 1 1 2 3 \n5 2 2 2 2 1 3 4 \n6 3 2 2 2 2 5 6 3 \n7 15 2 4 1 4 \n"
                   "$EndElements\n"));
  }

  TEST_CASE("bounding boxes and physical tags of entities are those of their elements") {
    const Scratch scratch;
    write_gmsh(scratch / "m.msh", small_file(), {GmshVersion::v4_1, false});
    CHECK(contains(contents(scratch / "m.msh"),
                   "$Entities\n0 2 2 0 \n3 0 0 0 2 0 0 1 10 0 \n5 0 0 0 0 1 0 1 11 0 \n"
                   "1 0 0 0 1 1 0 1 1 0 \n2 0 0 0 2 1 0 1 2 0 \n$EndEntities\n"));
  }

  TEST_CASE("a mesh that cannot be written leaves the old file and no other") {
    const Scratch scratch;
    write_text(scratch / "m.msh", "old");
    MeshFile negative = small_file();
    negative.mesh.triangle_regions[0] = -2;
    MeshFile outside = small_file();
    outside.mesh.quads[0][1] = 6;
    MeshFile short_field = small_file();
    short_field.vertex_fields = {{"u", 1, {1, 2}, 0, 0}};
    MeshFile two_components = small_file();
    two_components.element_fields = {{"q", 2, {1, 2, 3, 4, 5, 6}, 0, 0}};
    const auto message = [&](const MeshFile& file) {
      return message_of([&] { write_gmsh(scratch / "m.msh", file); });
    };
    CHECK(contains(message(negative), "tag -2 is negative"));
    CHECK(contains(message(outside), "a quad names vertex index 6 of 6"));
    CHECK(contains(message(short_field), "field 'u' has 2 entries, expected 6"));
    CHECK(contains(message(two_components), "field 'q' has 2 components, expected 1, 3 or 9"));
    CHECK(contents(scratch / "m.msh") == "old");
    CHECK(scratch.file_count() == 1);
  }
}

TEST_SUITE("property") {
  TEST_CASE("every array of a mesh file survives all four Gmsh flavours bit by bit") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const MeshFile file = full_file(seed);
      for (const GmshFormat format : kFlavours)
        REQUIRE(differences(round_trip(file, format), file) == "");
    }
  }
}
