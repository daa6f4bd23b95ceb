#include "drivers/cycle_files.hpp"

#include <algorithm>

#include <spdlog/fmt/fmt.h>

#include "drivers/element_names.hpp"
#include "drivers/quality_fields.hpp"
#include "drivers/text.hpp"
#include "mesher/io/mesh_io.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

void remove_earlier_cycles(const fs::path& folder) {
  std::vector<fs::path> old;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().starts_with("cycle")) old.push_back(entry.path());
  for (const fs::path& path : old) fs::remove(path);
}

FileField file_field(const Analysis::Field& field, int cycle) {
  return {field.name, field.components, field.values, static_cast<double>(cycle), cycle};
}

MeshFile with_fields(const Mesh& mesh, const Analysis& analysis, int cycle) {
  MeshFile file{mesh, {}, {}};
  if (!analysis.metric.empty()) {
    file.vertex_fields.push_back(metric_file_field(analysis.metric));
    file.vertex_fields.back().time = cycle;
    file.vertex_fields.back().step = cycle;
  }
  for (const auto& field : analysis.vertex_fields)
    file.vertex_fields.push_back(file_field(field, cycle));
  for (const auto& field : analysis.element_fields)
    file.element_fields.push_back(file_field(field, cycle));
  return file;
}

/// VTK collection: https://www.paraview.org/Wiki/ParaView/Data_formats
std::string pvd(int last_cycle) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (int cycle = 0; cycle <= last_cycle; ++cycle)
    text += fmt::format("<DataSet timestep=\"{0}\" file=\"cycle-{0}.vtu\"/>\n", cycle);
  return text + "</Collection>\n</VTKFile>\n";
}

std::string without_quotes(const std::string& toml) {
  if (toml.size() < 2 || (toml.front() != '"' && toml.front() != '\'')) return toml;
  return toml.substr(1, toml.size() - 2);
}

}  // namespace

void write_cycle(const fs::path& folder, const std::vector<std::string>& formats, int cycle,
                 const Mesh& mesh, const Analysis& analysis) {
  make_folder(folder);
  if (cycle == 0) remove_earlier_cycles(folder);
  MeshFile file = with_fields(mesh, analysis, cycle);
  const auto asked = [&](const char* format) {
    return std::find(formats.begin(), formats.end(), format) != formats.end();
  };
  for (const char* format : {"msh", "svg", "mesh"})
    // The .msh is always there: the report is made from it.
    if (asked(format) || std::string_view(format) == "msh")
      write_mesh_file(folder / fmt::format("cycle-{}.{}", cycle, format), file);
  if (!asked("vtu")) return;
  add_quality_fields(file, analysis.metric, cycle);
  write_mesh_file(folder / fmt::format("cycle-{}.vtu", cycle), file);
  write_text_file(folder / "cycles.pvd", pvd(cycle));
}

std::vector<std::pair<std::string, std::string>> variant_settings(const Variant& variant) {
  const Study& study = variant.study;
  std::vector<std::pair<std::string, std::string>> settings{
      {"adapt.mode", study.mode == AdaptMode::isotropic ? "isotropic" : "anisotropic"},
      {"adapt.cycles", std::to_string(study.cycles)},
      {"mesh.elements", name_of(kElementNames, study.elements)},
      {"mesh.preset", study.preset == Preset::paper ? "paper" : "best"}};
  if (study.elements != Elements::triangle) {
    settings.emplace_back("mesh.quad_method", name_of(kQuadMethodNames, study.quads.method));
    settings.emplace_back("mesh.quad_effort", name_of(kQuadEffortNames, study.quads.effort));
    settings.emplace_back("mesh.quad_start", name_of(kQuadStartNames, study.quads.start));
  }
  if (study.target.nodes)
    settings.emplace_back("adapt.target.nodes", std::to_string(*study.target.nodes));
  if (study.target.error)
    settings.emplace_back("adapt.target.error", fmt::format("{}", *study.target.error));
  for (const Override& value : variant.values) {
    const auto same = [&](const auto& setting) { return setting.first == value.key; };
    if (std::none_of(settings.begin(), settings.end(), same))
      settings.emplace_back(value.key, without_quotes(value.value));
  }
  if (!study.paper_row.empty()) settings.emplace_back("report.paper", study.paper_row);
  return settings;
}

}  // namespace anisofront
