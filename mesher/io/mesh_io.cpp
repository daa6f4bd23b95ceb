#include "mesher/io/mesh_io.hpp"

#include "mesher/geometry/error.hpp"
#include "mesher/io/mesh_arrays.hpp"
#include "mesher/io/metric_entry.hpp"
#include "mesher/io/svg.hpp"
#include "mesher/io/vtu.hpp"

namespace anisofront {

namespace {

[[noreturn]] void fail_suffix(const std::filesystem::path& path, const char* expected) {
  throw InputError(path.string() + ": the suffix '" + path.extension().string() +
                   "' names no known format, expected " + expected);
}

const FileField* find_field(const std::vector<FileField>& fields, std::string_view name) {
  for (const FileField& field : fields)
    if (field.name == name) return &field;
  return nullptr;
}

/// Entry v of a field of 9 components (row-major tensor), 3 (m11 m12 m22) or 1 (size h).
Metric metric_entry(const FileField& field, std::size_t v) {
  const double* values = field.values.data() + v * static_cast<std::size_t>(field.components);
  if (field.components == 1) return metric_of_size(values[0]);
  if (field.components == 3) return {values[0], values[1], values[2]};
  return {values[0], values[1], values[4]};
}

MetricField metric_entries(const FileField& field) {
  MetricField metric(field.values.size() / static_cast<std::size_t>(field.components));
  for (std::size_t v = 0; v < metric.size(); ++v) metric[v] = metric_entry(field, v);
  return metric;
}

/// Of a tensor of 9 values; other programs may leave rounding errors. NaN counts as symmetric.
bool is_symmetric(const double* values) {
  constexpr double kTolerance = 1e-10;
  return !(std::fabs(values[1] - values[3]) >
           kTolerance * (std::fabs(values[0]) + std::fabs(values[4])));
}

const char* entry_defect(const FileField& field, std::size_t v) {
  const double* values = field.values.data() + v * static_cast<std::size_t>(field.components);
  if (field.components == 1) return size_defect(values[0]);
  if (field.components == 9 && !is_symmetric(values)) return "is not symmetric";
  return metric_defect(metric_entry(field, v));
}

void check_entries(const std::filesystem::path& path, const MeshFile& file,
                   const FileField& field) {
  for (std::size_t v = 0; v < file.mesh.points.size(); ++v)
    if (const char* defect = entry_defect(field, v)) {
      const Point p = file.mesh.points[v];
      throw InputError(path.string() + ": field '" + field.name + "': the metric of vertex " +
                       std::to_string(v + 1) + " at (" + std::to_string(p.x) + ", " +
                       std::to_string(p.y) + ") " + defect);
    }
}

MetricField read_gmsh_metric(const std::filesystem::path& path, Index vertex_count) {
  const MeshFile file = read_gmsh(path);
  const FileField* field = find_field(file.vertex_fields, "metric");
  if (!field && !file.vertex_fields.empty()) field = &file.vertex_fields.front();
  if (!field) throw InputError(path.string() + ": no node data, expected a field 'metric'");
  if (field->components == 3)
    throw InputError(path.string() + ": field '" + field->name +
                     "' is a vector, expected a tensor (9 components) or a size (1 component)");
  if (file.mesh.points.size() != static_cast<std::size_t>(vertex_count))
    throw InputError(path.string() + ": metrics of " + std::to_string(file.mesh.points.size()) +
                     " vertices, but the mesh has " + std::to_string(vertex_count));
  check_entries(path, file, *field);
  return metric_entries(*field);
}

void write_medit_files(const std::filesystem::path& path, const MeshFile& file) {
  require_writable(file, path.string());
  write_medit(path, file.mesh);
  const FileField* field = find_field(file.vertex_fields, "metric");
  if (!field || field->components == 1) return;
  std::filesystem::path metric_path = path;
  write_medit_metric(metric_path.replace_extension(".sol"), metric_entries(*field));
}

}  // namespace

MeshFile read_mesh_file(const std::filesystem::path& path, const Monitor& monitor) {
  const std::filesystem::path suffix = path.extension();
  if (suffix == ".msh") return read_gmsh(path, monitor);
  if (suffix == ".mesh")
    return {.mesh = read_medit(path, monitor), .vertex_fields = {}, .element_fields = {}};
  fail_suffix(path, ".msh (Gmsh) or .mesh (Medit)");
}

void write_mesh_file(const std::filesystem::path& path, const MeshFile& file, GmshFormat format) {
  const std::filesystem::path suffix = path.extension();
  if (suffix == ".msh") return write_gmsh(path, file, format);
  if (suffix == ".mesh") return write_medit_files(path, file);
  if (suffix == ".vtu") return write_vtu(path, file);
  if (suffix == ".svg") return write_svg(path, file.mesh);
  fail_suffix(path, ".msh (Gmsh), .mesh (Medit), .vtu (VTK) or .svg");
}

MetricField read_metric_file(const std::filesystem::path& path, Index vertex_count) {
  const std::filesystem::path suffix = path.extension();
  if (suffix == ".sol") return read_medit_metric(path, vertex_count);
  if (suffix == ".msh") return read_gmsh_metric(path, vertex_count);
  fail_suffix(path, ".sol (Medit) or .msh (Gmsh)");
}

FileField metric_file_field(const MetricField& field) {
  FileField result{.name = "metric", .components = 9, .values = {}};
  result.values.reserve(9 * field.size());
  for (const Metric& m : field)
    result.values.insert(result.values.end(), {m.m11, m.m12, 0, m.m12, m.m22, 0, 0, 0, 0});
  return result;
}

}  // namespace anisofront
