#include "drivers/report/mesh_picture.hpp"

#include <algorithm>
#include <optional>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/process.hpp"
#include "drivers/report/figure_text.hpp"
#include "drivers/report/mesh_detail.hpp"
#include "mesher/io/gmsh.hpp"
#include "mesher/io/svg.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

const char* const kNoConverter =
    "rsvg-convert is not installed (Debian: librsvg2-bin): pictures of meshes are left as .svg";

std::optional<MeshFile> read_cycle(const fs::path& directory, const std::string& name, int cycle) {
  const fs::path path = directory / name / fmt::format("cycle-{}.msh", cycle);
  if (!fs::is_regular_file(path)) return {};
  return read_gmsh(path);
}

bool same_mesh(const Mesh& a, const Mesh& b) {
  return a.points == b.points && a.triangles == b.triangles && a.quads == b.quads;
}

const FileField* scalar_field(const MeshFile& file) {
  for (const FileField& field : file.vertex_fields)
    if (field.components == 1 && field.name != "metric") return &field;
  return nullptr;
}

/// Mean of the values at the vertices of each element.
std::vector<double> element_means(const Mesh& mesh, const std::vector<double>& values) {
  std::vector<double> means;
  const auto add = [&](const auto& element) {
    double sum = 0;
    for (const Index v : element) sum += values[static_cast<std::size_t>(v)];
    means.push_back(sum / static_cast<double>(element.size()));
  };
  for (const Triangle& triangle : mesh.triangles) add(triangle);
  for (const Quad& quad : mesh.quads) add(quad);
  return means;
}

/// What all pictures of a report share.
struct Gallery {
  FigureFolder& folder;
  std::vector<MeshPicture> pictures;
};

void draw(Gallery& gallery, MeshPicture picture, const Mesh& mesh, SvgOptions options) {
  constexpr double kHighest = 1.5;
  options.has_scale = true;
  options.highest = kHighest;
  picture.stem = gallery.folder.free_stem(picture.stem);
  write_svg(gallery.folder.path() / (picture.stem + ".svg"), mesh, options);
  gallery.folder.add(picture.stem + ".svg");
  gallery.pictures.push_back(std::move(picture));
}

using NamedMesh = std::pair<std::string, Mesh>;

std::vector<NamedMesh> initial_meshes(const Json& history, const fs::path& directory) {
  std::vector<NamedMesh> meshes;
  for (const Json& variant : history.at("variants")) {
    const std::string name = variant.at("name");
    if (auto file = read_cycle(directory, name, 0))
      meshes.emplace_back(name, std::move(file->mesh));
  }
  return meshes;
}

void draw_initial(Gallery& gallery, const std::vector<NamedMesh>& meshes) {
  const bool are_same = std::all_of(meshes.begin(), meshes.end(), [&](const NamedMesh& other) {
    return same_mesh(other.second, meshes.front().second);
  });
  for (const auto& [name, mesh] : meshes) {
    if (are_same) return draw(gallery, {"mesh-initial", "Initial mesh", {}}, mesh, {});
    draw(gallery, {file_stem(name) + "-mesh-initial", "Initial mesh", name}, mesh, {});
  }
}

void draw_last(Gallery& gallery, const std::string& name, int cycle, const MeshFile& file) {
  const std::string stem = file_stem(name) + "-";
  SvgOptions whole, detail;
  whole.framed = detail.window = detail_window(file.mesh);
  draw(gallery, {stem + "mesh", fmt::format("Mesh of cycle {}", cycle), name}, file.mesh, whole);
  if (detail.window)
    draw(gallery,
         {stem + "mesh-zoom", fmt::format("Framed part of the mesh of cycle {}", cycle), name},
         file.mesh, detail);
  const FileField* field = scalar_field(file);
  if (!field) return;
  SvgOptions coloured;
  coloured.values = element_means(file.mesh, field->values);
  coloured.values_name = field->name;
  draw(gallery, {stem + "solution", fmt::format("{} of cycle {}", field->name, cycle), name},
       file.mesh, coloured);
}

}  // namespace

std::vector<MeshPicture> draw_meshes(const Json& history, const fs::path& directory,
                                     FigureFolder& folder) {
  Gallery gallery{folder, {}};
  draw_initial(gallery, initial_meshes(history, directory));
  for (const Json& variant : history.at("variants")) {
    if (variant.at("cycles").empty()) continue;
    const std::string name = variant.at("name");
    const int cycle = variant.at("cycles").back().at("cycle");
    if (cycle == 0) continue;  // the initial mesh
    if (const auto file = read_cycle(directory, name, cycle))
      draw_last(gallery, name, cycle, *file);
  }
  return std::move(gallery.pictures);
}

std::vector<std::string> convert_pictures(const std::vector<MeshPicture>& pictures,
                                          FigureFolder& folder) {
  std::vector<std::vector<std::string>> commands;
  for (const MeshPicture& picture : pictures)
    commands.push_back({"rsvg-convert", "--unlimited", "-w", "1200", "-o", picture.stem + ".png",
                        picture.stem + ".svg"});
  const std::vector<ProgramRun> runs = run_programs_in(folder.path(), commands);
  std::vector<std::string> failed;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].status == kProgramNotFound) return {kNoConverter};
    if (runs[i].status != 0 || !folder.add(pictures[i].stem + ".png"))
      failed.push_back(pictures[i].stem);
  }
  if (failed.empty()) return {};
  return {fmt::format("rsvg-convert cannot draw {} of {} pictures, the first {}", failed.size(),
                      pictures.size(), (folder.path() / (failed.front() + ".svg")).string())};
}

}  // namespace anisofront
