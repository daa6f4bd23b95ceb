#include <cstdlib>

#include <doctest/doctest.h>

#include "io_support.hpp"
#include "mesher/io/mesh_io.hpp"

// Against the real Gmsh, when it is installed: it reads what we write without a warning, and we
// read what it writes exactly.

using namespace anisofront;
using namespace anisofront::test;

namespace {

bool has_gmsh() {
  const bool found = std::system("command -v gmsh > /dev/null 2>&1") == 0;
  if (!found) MESSAGE("gmsh is not installed: skipped");
  return found;
}

/// What Gmsh prints; the arguments are given to a shell.
std::string gmsh(const Scratch& scratch, const std::string& arguments) {
  const std::string log = (scratch / "log").string();
  const int status = std::system(("gmsh " + arguments + " > '" + log + "' 2>&1").c_str());
  return (status == 0 ? "" : "Error: gmsh failed\n") + contents(log);
}

bool is_clean(const std::string& output) {
  return contains(output, "Done") && !contains(output, "Warning") && !contains(output, "Error");
}

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

const std::vector<std::string> kFlavourOptions{"-format msh22", "-format msh22 -bin",
                                               "-format msh41", "-format msh41 -bin"};

/// The two squares of tests/data/gmsh with fields and everything that goes to $Anisofront.
MeshFile file_with_fields() {
  const auto folder = std::filesystem::path(ANISOFRONT_TEST_DATA) / "gmsh";
  MeshFile file = read_gmsh(folder / "two-squares.22.ascii.msh");
  file.mesh.corners = {3, 4};
  file.mesh.edges[2].parameters = {0.25, 0.5};
  MetricField metric;
  FileField flow{"flow", 3, {}, 0.5, 1};
  for (const Point p : file.mesh.points) {
    metric.push_back({1 + p.x, 0.1, 2 + p.y});
    flow.values.insert(flow.values.end(), {p.x, p.y, 0});
  }
  file.vertex_fields = {metric_file_field(metric), flow};
  file.element_fields = {
      {"error", 1, std::vector<double>(file.mesh.triangles.size(), 0.125), 0, 0}};
  return file;
}

}  // namespace

TEST_SUITE("external") {
  TEST_CASE("meshes made afresh by Gmsh are the same in all four flavours") {
    if (!has_gmsh()) return;
    const Scratch scratch;
    const auto geometry = std::filesystem::path(ANISOFRONT_TEST_DATA) / "gmsh" / "two-squares.geo";
    std::vector<Mesh> meshes;
    for (const std::string& options : kFlavourOptions) {
      const std::string output = gmsh(scratch, "-2 -clmax 0.1 " + quoted(geometry) + " " + options +
                                                   " -o " + quoted(scratch / "m.msh"));
      REQUIRE(is_clean(output));
      meshes.push_back(read_gmsh(scratch / "m.msh").mesh);
    }
    CHECK(meshes[0].triangles.size() > 400);
    CHECK(differences(meshes[0], meshes[2]) == "");  // text: 16 digits
    CHECK(differences(meshes[1], meshes[3]) == "");  // binary: all bits
    for (std::size_t v = 0; v < meshes[0].points.size(); ++v)
      REQUIRE(norm(meshes[0].points[v] - meshes[1].points[v]) <= 1e-15);
    meshes[1].points = meshes[0].points;
    CHECK(differences(meshes[0], meshes[1]) == "");
  }

  TEST_CASE("what we write opens in Gmsh without a warning and comes back the same") {
    if (!has_gmsh()) return;
    const MeshFile file = file_with_fields();
    for (const GmshFormat format : kFlavours) {
      const Scratch scratch;
      write_gmsh(scratch / "ours.msh", file, format);
      CHECK(is_clean(gmsh(scratch, quoted(scratch / "ours.msh") + " -check")));
      CHECK(is_clean(gmsh(scratch, quoted(scratch / "ours.msh") + " -save -bin -format msh41 -o " +
                                       quoted(scratch / "theirs.msh"))));
      Mesh expected = file.mesh;
      expected.corners.clear();
      expected.edges[2].parameters = {0, 0};
      CHECK(differences(read_gmsh(scratch / "theirs.msh").mesh, expected) == "");
    }
  }

  TEST_CASE("fields we write are fields in Gmsh") {
    if (!has_gmsh()) return;
    const MeshFile file = file_with_fields();
    for (const GmshFormat format : kFlavours) {
      const Scratch scratch;
      write_gmsh(scratch / "ours.msh", file, format);
      write_text(scratch / "save.geo",
                 "Merge \"ours.msh\"; PostProcessing.SaveMesh=1; Mesh.Binary=1;\n"
                 "Save View[0] \"metric.msh\"; Save View[1] \"flow.msh\"; "
                 "Save View[2] \"error.msh\";\n");
      REQUIRE(is_clean(gmsh(scratch, quoted(scratch / "save.geo") + " -")));
      CHECK(same_fields(read_gmsh(scratch / "metric.msh").vertex_fields, {file.vertex_fields[0]}));
      CHECK(same_fields(read_gmsh(scratch / "flow.msh").vertex_fields, {file.vertex_fields[1]}));
      CHECK(same_fields(read_gmsh(scratch / "error.msh").element_fields, file.element_fields));
    }
  }

  TEST_CASE("meshes of quads and triangles in several regions open in Gmsh without a warning") {
    if (!has_gmsh()) return;
    for (const GmshFormat format : kFlavours) {
      const Scratch scratch;
      write_gmsh(scratch / "ours.msh", small_file(), format);
      CHECK(is_clean(gmsh(scratch, quoted(scratch / "ours.msh") + " -check")));
    }
  }
}
