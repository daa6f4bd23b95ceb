#include "drivers/report/mesh_picture.hpp"

#include <cstdlib>

#include <doctest/doctest.h>

#include "drivers/base/text.hpp"
#include "drivers/report/mesh_detail.hpp"
#include "mesher/io/gmsh.hpp"
#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

namespace fs = std::filesystem;

/// n x n squares of two triangles on the unit square; columns get thinner to the left, towards a
/// width of `thinnest`.
Mesh graded_mesh(Index n, double thinnest) {
  Mesh mesh;
  const double ratio = std::pow(thinnest, 1. / static_cast<double>(n - 1));
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i)
      mesh.points.push_back({i == 0 ? 0 : std::pow(ratio, n - i), static_cast<double>(j) / n});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i, b = a + n + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  mesh.triangle_regions.assign(mesh.triangles.size(), 1);
  return mesh;
}

Json history_of(const std::vector<std::string>& names, int last) {
  Json history{{"variants", Json::array()}};
  for (const std::string& name : names) {
    Json cycles = Json::array();
    for (int k = 0; k <= last; ++k) cycles.push_back({{"cycle", k}});
    history["variants"].push_back({{"name", name}, {"cycles", cycles}});
  }
  return history;
}

void write_cycle_mesh(const fs::path& folder, int cycle, const Mesh& mesh, bool has_field = false) {
  fs::create_directories(folder);
  MeshFile file{mesh, {}, {}};
  if (has_field) {
    FileField field{.name = "u", .components = 1, .values = {}};
    for (const Point p : mesh.points) field.values.push_back(p.x);
    file.vertex_fields.push_back(field);
  }
  write_gmsh(folder / ("cycle-" + std::to_string(cycle) + ".msh"), file);
}

std::vector<std::string> stems_of(const std::vector<MeshPicture>& pictures) {
  std::vector<std::string> stems;
  for (const MeshPicture& picture : pictures) stems.push_back(picture.stem);
  return stems;
}

using Stems = std::vector<std::string>;

}  // namespace

TEST_SUITE_BEGIN("unit");

TEST_CASE("thin elements get a window of their own") {
  const Mesh mesh = graded_mesh(20, 1e-3);
  const auto window = detail_window(mesh);
  REQUIRE(window);
  CHECK(window->low.x < 0);  // a bit of blank beside the boundary
  CHECK(window->low.x > -0.1 * window->high.x);
  CHECK(window->high.x < 0.5);
  CHECK(window->high.x - window->low.x == doctest::Approx(window->high.y - window->low.y));
  CHECK(window->low.y > -0.1);
  CHECK(window->high.y < 1.1);
}

TEST_CASE("meshes of like sizes have no window") {
  CHECK_FALSE(detail_window(graded_mesh(10, 0.1)));
  CHECK_FALSE(detail_window(Mesh{}));
  Mesh flat;
  flat.points = {{0, 0}, {1, 0}, {2, 0}};
  flat.triangles = {{0, 1, 2}};
  flat.triangle_regions = {1};
  CHECK_FALSE(detail_window(flat));
}

TEST_CASE("variants that start alike share the picture of the initial mesh") {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b"}) {
    write_cycle_mesh(folder.path() / name, 0, graded_mesh(4, 0.3));
    write_cycle_mesh(folder.path() / name, 2, graded_mesh(20, 1e-3), name[0] == 'b');
  }
  FigureFolder figures(folder.path() / "figures");
  const auto pictures = draw_meshes(history_of({"a", "b"}, 2), folder.path(), figures);
  CHECK(stems_of(pictures) ==
        Stems{"mesh-initial", "a-mesh", "a-mesh-zoom", "b-mesh", "b-mesh-zoom", "b-solution"});
  CHECK(pictures[0].variant.empty());
  CHECK(pictures[4].variant == "b");
  CHECK(has(read_text_file(figures.path() / "a-mesh.svg"), "class=\"framed\""));
  CHECK(has(read_text_file(figures.path() / "a-mesh-zoom.svg"), "clip-path"));
  CHECK(has(read_text_file(figures.path() / "b-solution.svg"), ">u:   0<"));
  for (const MeshPicture& picture : pictures)
    CHECK(has(read_text_file(figures.path() / (picture.stem + ".svg")), "class=\"scale\""));
}

TEST_CASE("variants that start from other meshes have each its picture") {
  const TemporaryFolder folder;
  write_cycle_mesh(folder.path() / "a", 0, graded_mesh(4, 0.3));
  write_cycle_mesh(folder.path() / "b", 0, graded_mesh(5, 0.3));
  FigureFolder figures(folder.path() / "figures");
  CHECK(stems_of(draw_meshes(history_of({"a", "b", "missing"}, 0), folder.path(), figures)) ==
        Stems{"a-mesh-initial", "b-mesh-initial"});
}

TEST_CASE("pictures are converted to PNG where the program is there") {
  const TemporaryFolder folder;
  write_cycle_mesh(folder.path() / "a", 0, graded_mesh(4, 0.3));
  FigureFolder figures(folder.path() / "figures");
  const auto pictures = draw_meshes(history_of({"a"}, 0), folder.path(), figures);
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  const auto problems = convert_pictures(pictures, figures);
  setenv("PATH", path.c_str(), 1);
  REQUIRE(problems.size() == 1);
  CHECK(has(problems[0], "rsvg-convert is not installed"));
  REQUIRE(convert_pictures(pictures, figures).empty());
  const std::string png = read_text_file(figures.path() / "mesh-initial.png");
  CHECK(png.starts_with("\x89PNG\r\n"));
  CHECK(png.substr(16, 4) == std::string("\0\0\x04\xb0", 4));  // 1200 wide
  write_text_file(figures.path() / "mesh-initial.svg", "damaged");
  CHECK(has(convert_pictures(pictures, figures).at(0), "cannot draw 1 of 1"));
  CHECK(convert_pictures({}, figures).empty());
}

TEST_SUITE_END();
