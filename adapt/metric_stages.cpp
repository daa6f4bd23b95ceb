#include "adapt/metric_stages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "adapt/equidistribution.hpp"
#include "mesher/background/background_mesh.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

/// Change of a size that counts as a decision.
constexpr double kNoticeable = 0.01;

double diagonal(const Mesh& mesh) {
  Box box{mesh.points[0], mesh.points[0]};
  for (const Point p : mesh.points) box = enclosing(box, p);
  return norm(box.high - box.low);
}

/// One metric per vertex to be intersected with the density; empty when there is none.
MetricField layer_part(const Mesh& mesh, const LayerFrame& frame, const LayerSettings& layers,
                       const StageOptions& options) {
  if (layers.tags.empty() || !options.use_layer_metric) return {};
  MetricField field =
      layer_metric(mesh, frame, layers, std::min(options.limits.hmax, diagonal(mesh)));
  if (options.density.mode == AdaptMode::isotropic)
    for (Metric& m : field) m = metric_from_size(principal_axes(m).h1);
  return field;
}

/// What the stages are made of. `curvature`: the density of the Hessians alone, empty when it is
/// the density.
struct StageParts {
  PrincipalField curvature, density;
  MetricField layer;
};

std::vector<MetricStage> stages_of(const Mesh& mesh, const StageParts& parts,
                                   const MetricMeasure& measure, double vertices,
                                   const MetricLimits& limits, const ScaledMetric& result) {
  const auto& [curvature, density, layer] = parts;
  const auto unlimited = [&](const PrincipalField& field) {
    return scale_metric(mesh, field, measure, vertices, {});
  };
  std::vector<MetricStage> stages;
  if (!curvature.empty()) stages.push_back({"curvature", unlimited(curvature).field});
  const double alone = unlimited(density).factor;
  const auto add = [&](const char* name, double factor, std::span<const Metric> beside,
                       const MetricLimits& with) {
    stages.push_back({name, bounded_metric(density, factor, with, beside)});
  };
  add("density", alone, {}, {});
  add("scaled", result.factor, {}, {});
  if (!layer.empty()) add("layer", result.factor, layer, {});
  add("size limits", result.factor, layer, {.hmin = limits.hmin, .hmax = limits.hmax});
  add("stretch limit", result.factor, layer, limits);
  stages.push_back({"gradation", result.field});
  return stages;
}

bool is_changed(double from, double to) { return std::abs(to - from) > kNoticeable * from; }

/// Marks the stage that set the given size.
void mark_decision(std::vector<StageSizes>& sizes, double StageSizes::*size,
                   bool StageSizes::*decided) {
  std::size_t last = 0;
  for (std::size_t k = 1; k < sizes.size(); ++k)
    if (sizes[k].stage != "scaled" && is_changed(sizes[k - 1].*size, sizes[k].*size)) last = k;
  sizes[last].*decided = true;
}

std::string reason(const std::string& stage, double before, double after) {
  if (stage == "curvature") return "the curvature of the solution";
  if (stage == "density") return "the error";
  if (stage == "layer") return "the a-priori metric of the layer";
  if (stage == "size limits") return after > before ? "hmin" : "hmax";
  if (stage == "stretch limit") return "the largest stretch";
  if (stage == "gradation") return "the gradation (smaller sizes nearby)";
  return stage;
}

/// Four digits are enough for people.
std::string rounded(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

/// A direction without a sense: to the right, in thousandths.
std::string direction(Vector e) {
  if (e.x < 0 || (e.x == 0 && e.y < 0)) e = -e;
  const auto thousandths = [](double x) { return rounded(std::round(1000 * x) / 1000 + 0.); };
  return std::string("(")
      .append(thousandths(e.x))
      .append(", ")
      .append(thousandths(e.y))
      .append(")");
}

/// The stage before stage k, "scaled" left out: its sizes are those of the density times a factor,
/// which is far off where the later limits make the number of vertices impossible.
std::size_t stage_before(const std::vector<StageSizes>& stages, std::size_t k) {
  do --k;
  while (k > 0 && stages[k].stage == "scaled");
  return k;
}

std::string sentence(const std::vector<StageSizes>& stages, double StageSizes::*size,
                     bool StageSizes::*decided, const std::string& which) {
  std::size_t k = 0;
  while (!(stages[k].*decided)) ++k;
  const double before = stages[k == 0 ? 0 : stage_before(stages, k)].*size;
  std::string text = "The size ";
  text.append(rounded(stages.back().*size)).append(" ").append(which).append(" is set by ");
  text.append(reason(stages[k].stage, before, stages[k].*size));
  if (k > 0) text.append("; before it was ").append(rounded(before));
  return text.append(".");
}

}  // namespace

StagedMetric make_metric(const FeMesh& fe, FieldHessians fields, const LayerSettings& layers,
                         double vertices, const StageOptions& options,
                         const Contributions& contributions) {
  const Mesh& mesh = fe.mesh;
  const LayerFrame frame = layer_frame(fe, layers);
  if (options.align) align_with_layers(frame, layers.reach * layers.width, fields);
  StageParts parts{{}, metric_density(mesh, fields, options.density), {}};
  if (!contributions.values.empty()) {
    if (options.keep_stages) parts.curvature = parts.density;
    equidistribute(mesh, contributions.values, contributions.order, options.limits.stretch,
                   parts.density);
  }
  parts.layer = layer_part(mesh, frame, layers, options);
  const MetricMeasure measure = vertex_measure(mesh, options.elements);
  ScaledMetric scaled =
      scale_metric(mesh, parts.density, measure, vertices, options.limits, parts.layer);
  StagedMetric result;
  if (options.keep_stages)
    result.stages = stages_of(mesh, parts, measure, vertices, options.limits, scaled);
  result.field = std::move(scaled.field);
  result.measure = scaled.measure;
  return result;
}

std::vector<StageSizes> explain_metric(const Mesh& mesh, const std::vector<MetricStage>& stages,
                                       Point p) {
  if (stages.empty())
    throw InputError("the stages of the metric were not kept; ask for them when it is made");
  std::vector<StageSizes> sizes;
  Index hint = 0;
  for (const MetricStage& stage : stages) {
    const PrincipalAxes axes = principal_axes(BackgroundMesh(mesh, stage.field).metric_at(p, hint));
    sizes.push_back({stage.name, axes.h1, axes.h2, axes.e1});
  }
  mark_decision(sizes, &StageSizes::h1, &StageSizes::decided_h1);
  mark_decision(sizes, &StageSizes::h2, &StageSizes::decided_h2);
  return sizes;
}

std::string describe_stages(const std::vector<StageSizes>& stages) {
  const std::string along = std::string("along ").append(direction(stages.back().e1));
  return sentence(stages, &StageSizes::h1, &StageSizes::decided_h1, along)
      .append("\n")
      .append(sentence(stages, &StageSizes::h2, &StageSizes::decided_h2, "across"));
}

double plate_stretch_limit(double length, double thickness) {
  return std::clamp(0.15 * length / thickness, 10., 150.);
}

}  // namespace anisofront
