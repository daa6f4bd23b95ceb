#include "drivers/report/cycle_blob.hpp"

#include "drivers/base/compress.hpp"
#include "drivers/report/mesh_blob.hpp"
#include "mesher/background/background_mesh.hpp"
#include "mesher/io/mesh_io.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

fs::path mesh_path(const fs::path& folder, int cycle) {
  return folder / ("cycle-" + std::to_string(cycle) + ".msh");
}

/// The metric that was computed on the mesh of a cycle.
MetricFunction metric_on(const fs::path& folder, int cycle, Interpolation interpolation) {
  const fs::path path = mesh_path(folder, cycle);
  const Mesh mesh = read_gmsh(path).mesh;
  return background_metric(mesh, read_metric_file(path, static_cast<Index>(mesh.points.size())),
                           interpolation);
}

}  // namespace

std::string cycle_blob(const fs::path& folder, int cycle, Interpolation interpolation) {
  const MeshFile file = read_gmsh(mesh_path(folder, cycle));
  MetricFunction metric;
  std::string note;
  try {
    metric = metric_on(folder, cycle == 0 ? 0 : cycle - 1, interpolation);
  } catch (const Error& error) {
    note = std::string("Lengths and quality in the metric are not known: ") + error.what();
  }
  return gzip(mesh_blob(file, metric, note));
}

}  // namespace anisofront
