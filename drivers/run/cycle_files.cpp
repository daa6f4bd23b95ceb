#include "drivers/run/cycle_files.hpp"

#include <algorithm>
#include <charconv>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "drivers/run/line_files.hpp"
#include "drivers/run/quality_fields.hpp"
#include "drivers/study/element_names.hpp"
#include "mesher/io/mesh_io.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

/// Files know scalars, vectors of 3 components and tensors of 9: plane vectors get a third.
FileField file_field(const Analysis::Field& field, int cycle) {
  FileField result{field.name, field.components, field.values, static_cast<double>(cycle), cycle};
  if (field.components != 2) return result;
  result.components = 3;
  result.values.clear();
  for (std::size_t i = 0; i + 1 < field.values.size(); i += 2)
    result.values.insert(result.values.end(), {field.values[i], field.values[i + 1], 0});
  return result;
}

FileField metric_field(const MetricField& metric, const std::string& name, int cycle) {
  FileField field = metric_file_field(metric);
  field.name = name;
  field.time = cycle;
  field.step = cycle;
  return field;
}

MeshFile with_fields(const Mesh& mesh, const Analysis& analysis, int cycle) {
  MeshFile file{mesh, {}, {}};
  if (!analysis.metric.empty())
    file.vertex_fields.push_back(metric_field(analysis.metric, "metric", cycle));
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

/// "size limits" -> "size-limits".
std::string as_file_name(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

bool asks_for(const std::vector<std::string>& formats, const std::string& format) {
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

/// One file with all stages for Gmsh and ParaView; Medit shows one metric at a time.
void write_stages(const fs::path& folder, const std::vector<std::string>& formats, int cycle,
                  const Mesh& mesh, const std::vector<MetricStage>& stages) {
  MeshFile all{mesh, {}, {}};
  for (const MetricStage& stage : stages)
    all.vertex_fields.push_back(metric_field(stage.field, stage.name, cycle));
  write_mesh_file(folder / fmt::format("cycle-{}-stages.msh", cycle), all);
  if (asks_for(formats, "vtu"))
    write_mesh_file(folder / fmt::format("cycle-{}-stages.vtu", cycle), all);
  if (!asks_for(formats, "mesh")) return;
  for (const MetricStage& stage : stages)
    write_mesh_file(folder / fmt::format("cycle-{}-{}.mesh", cycle, as_file_name(stage.name)),
                    {mesh, {metric_field(stage.field, "metric", cycle)}, {}});
}

/// What a run that was killed leaves of a file that it was writing (see AtomicFile).
bool is_half_written(const std::string& name) {
  return name.starts_with("record.json.part") || name.starts_with("cycles.pvd.part");
}

}  // namespace

int cycle_of(const std::string& name) {
  constexpr std::string_view kStem = "cycle-";
  int cycle = -1;
  if (name.starts_with(kStem))
    std::from_chars(name.data() + kStem.size(), name.data() + name.size(), cycle);
  return cycle;
}

void remove_cycles(const fs::path& folder, int first) {
  if (!fs::exists(folder)) return;
  std::vector<fs::path> old;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (cycle_of(name) >= first || is_half_written(name)) old.push_back(entry.path());
  }
  for (const fs::path& path : old) fs::remove(path);
  if (first == 0) fs::remove(folder / "cycles.pvd");
  remove_profiles(folder, first);
}

void write_cycle(const fs::path& folder, const std::vector<std::string>& formats, int cycle,
                 const Mesh& mesh, const Analysis& analysis) {
  make_folder(folder);
  write_profiles(folder, cycle, analysis.profiles);
  MeshFile file = with_fields(mesh, analysis, cycle);
  if (!analysis.stages.empty()) write_stages(folder, formats, cycle, mesh, analysis.stages);
  for (const char* format : {"msh", "svg", "mesh"})
    // The .msh is always there: the report is made from it.
    if (asks_for(formats, format) || std::string_view(format) == "msh")
      write_mesh_file(folder / fmt::format("cycle-{}.{}", cycle, format), file);
  if (!asks_for(formats, "vtu")) return;
  add_quality_fields(file, analysis.metric, cycle);
  write_mesh_file(folder / fmt::format("cycle-{}.vtu", cycle), file);
  write_text_file(folder / "cycles.pvd", pvd(cycle));
}

std::vector<std::pair<std::string, std::string>> variant_settings(const Variant& variant) {
  const Study& study = variant.study;
  std::vector<std::pair<std::string, std::string>> settings{
      {"adapt.mode", study.adapt.mode == AdaptMode::isotropic ? "isotropic" : "anisotropic"},
      {"adapt.cycles", std::to_string(study.adapt.cycles)},
      {"mesh.elements", name_of(kElementNames, study.elements)},
      {"mesh.preset", study.preset == Preset::paper ? "paper" : "best"}};
  if (study.elements != Elements::triangle) {
    settings.emplace_back("mesh.quad_method", name_of(kQuadMethodNames, study.quads.method));
    settings.emplace_back("mesh.quad_effort", name_of(kQuadEffortNames, study.quads.effort));
    settings.emplace_back("mesh.quad_start", name_of(kQuadStartNames, study.quads.start));
  }
  const Target& target = study.adapt.target;
  if (target.vertices)
    settings.emplace_back("adapt.target.nodes", fmt::format("{}", *target.vertices));
  if (target.error) settings.emplace_back("adapt.target.error", fmt::format("{}", *target.error));
  for (const Override& value : variant.values) {
    const auto same = [&](const auto& setting) { return setting.first == value.key; };
    if (std::none_of(settings.begin(), settings.end(), same))
      settings.emplace_back(value.key, without_quotes(value.value));
  }
  if (!study.paper_row.empty()) settings.emplace_back("report.paper", study.paper_row);
  return settings;
}

}  // namespace anisofront
