#include "drivers/commands/mesh_check.hpp"

#include <spdlog/fmt/fmt.h>

namespace anisofront {
namespace {

std::string histogram_text(const MeshStatistics& s) {
  std::string text;
  for (int bin = 0; bin < kLengthBins; ++bin) {
    const auto count = s.histogram[static_cast<std::size_t>(bin)];
    if (count == 0) continue;
    const double percent = 100. * static_cast<double>(count) / s.edges;
    const std::string upper =
        bin + 1 < kLengthBins ? fmt::format("{:.1f}", 0.1 * (bin + 1)) : "...";
    text += fmt::format("  {:.1f} - {:<4} {:>9} {:>7.2f} %  {:#<{}}\n", 0.1 * bin, upper, count,
                        percent, "", static_cast<int>(percent));
  }
  return text;
}

/// The paper's names for the quality of triangles and quadrilaterals.
const char* quality_name(const MeshStatistics& s) {
  if (s.quads == 0) return "alpha~";
  return s.triangles == 0 ? "beta~" : "alpha~ and beta~";
}

std::string scaled_jacobian_text(const MeshStatistics& s) {
  if (s.quads == 0) return {};
  return fmt::format("least scaled Jacobian of the quadrilaterals: {:.4f}\n",
                     s.scaled_jacobian_min);
}

/// What is known without a metric.
std::string shape_text(const MeshStatistics& s) {
  return fmt::format("shape quality {} (no metric): mean {:.4f}, min {:.4f}\n", quality_name(s),
                     s.quality_mean, s.quality_min) +
         fmt::format("corner angles: {:.1f} to {:.1f} degrees\n", s.angle_min, s.angle_max) +
         scaled_jacobian_text(s);
}

std::string metric_text(const MeshStatistics& s) {
  std::string text = fmt::format("quality {} in the metric: mean {:.4f}, min {:.4f}\n",
                                 quality_name(s), s.quality_mean, s.quality_min);
  text += fmt::format("edge length in the metric: {:.4f} to {:.4f}\n", s.length_min, s.length_max);
  text += fmt::format("edges in [0.5, 1.5]: {:.3f} %, in [1/sqrt2, sqrt2]: {:.3f} %\n",
                      s.percent_half, s.percent_unit);
  text += fmt::format("corner angles in the metric: {:.1f} to {:.1f} degrees\n", s.angle_min,
                      s.angle_max);
  text += scaled_jacobian_text(s);
  text += fmt::format("largest stretch: {:.4g}; integral of sqrt(det M): {:.6g}\n", s.stretch_max,
                      s.complexity);
  return text + histogram_text(s);
}

}  // namespace

MeshFindings examine_mesh(const std::string& file, const Mesh& mesh, const MetricField& metric) {
  MeshFindings findings{file, check_mesh(mesh), {}, !metric.empty()};
  if (!findings.report.valid()) return findings;
  const MetricField euclidean(metric.empty() ? mesh.points.size() : 0);
  findings.statistics = mesh_statistics(mesh, metric.empty() ? euclidean : metric);
  return findings;
}

Json findings_json(const MeshFindings& findings) {
  const MeshReport& r = findings.report;
  Json json{{"file", findings.file},
            {"valid", r.valid()},
            {"vertices", r.vertices},
            {"triangles", r.triangles},
            {"quads", r.quads},
            {"edges", r.edges},
            {"boundary_edges", r.boundary_edges},
            {"components", r.components},
            {"holes", r.holes},
            {"area", r.area},
            {"defects", r.defects}};
  if (!findings.statistics) return json;
  const MeshStatistics& s = *findings.statistics;
  const Json against = statistics_json(s, findings.has_metric ? "field" : "euclidean");
  json["scaled_jacobian_min"] = s.scaled_jacobian_min;
  if (!findings.has_metric) {
    json["quality"] = against["quality"];
    json["angle"] = against["angle"];
    return json;
  }
  json.update(against);
  json["stretch_max"] = s.stretch_max;
  return json;
}

std::string findings_text(const MeshFindings& findings) {
  const MeshReport& r = findings.report;
  std::string text = fmt::format("{}: {}\n", findings.file, r.valid() ? "valid" : "NOT VALID");
  text +=
      fmt::format("{} vertices, {} triangles, {} quadrilaterals, {} edges ({} on the boundary)\n",
                  r.vertices, r.triangles, r.quads, r.edges, r.boundary_edges);
  text += fmt::format("{} part(s), {} hole(s), area {:.12g}\n", r.components, r.holes, r.area);
  for (const std::string& defect : r.defects) text += "  " + defect + "\n";
  if (!findings.statistics) return text;
  if (findings.has_metric) return text + metric_text(*findings.statistics);
  return text + shape_text(*findings.statistics);
}

}  // namespace anisofront
