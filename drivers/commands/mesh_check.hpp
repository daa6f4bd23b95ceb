#pragma once

#include <optional>
#include <string>

#include "drivers/history/history_json.hpp"
#include "mesher/mesh/check.hpp"

namespace anisofront {

/// What `anisofront check` found out about a mesh.
struct MeshFindings {
  std::string file;
  MeshReport report;
  /// Against the metric, or (quality only) the Euclidean one. Empty when the mesh is not valid.
  std::optional<MeshStatistics> statistics;
  bool has_metric = false;
};

/// Validity and, for a valid mesh, statistics. `metric`: one per vertex, or empty.
MeshFindings examine_mesh(const std::string& file, const Mesh& mesh, const MetricField& metric);

Json findings_json(const MeshFindings& findings);
std::string findings_text(const MeshFindings& findings);

}  // namespace anisofront
