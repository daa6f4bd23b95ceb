#pragma once

#include <span>
#include <string>
#include <vector>

#include "adapt/layers.hpp"

namespace anisofront {

/// The metric after one stage of its making.
struct MetricStage {
  std::string name;  ///< see make_metric()
  MetricField field;
};

struct StageOptions {
  DensityOptions density{};
  MetricLimits limits{};
  /// Adds the a-priori layer metric (cycle 0). In isotropic mode it asks for its size across in
  /// both directions, which takes as many vertices as resolving the layer that way does.
  bool use_layer_metric = false;
  bool align = true;
  Elements elements = Elements::triangle;  ///< that the vertices are counted for
  bool keep_stages = false;
};

struct StagedMetric {
  MetricField field;
  double measure = 0;               ///< expected vertices, see ScaledMetric
  std::vector<MetricStage> stages;  ///< in order, when asked for
};

/// What the error estimate says of each element, for equidistribute().
struct Contributions {
  std::vector<double> values;  ///< per element; empty: the Hessians alone give the density
  int order = 1;
};

/// Hessians -> aligned -> density (equidistributed) -> scaled (with the layer metric, which keeps
/// its sizes) so that the metric with all limits on asks for `vertices`. The stages:
///   "curvature"      the Hessians alone, scaled as the next; only when it was equidistributed
///   "density"        what the error alone asks for: scaled to `vertices` without limits
///   "scaled"         the same by the factor that makes up for what the later stages add or take
///   "layer"          intersected with layer_metric(); only when it is used
///   "size limits"    hmin and hmax
///   "stretch limit"  the larger size gives way
///   "gradation"      smaller sizes nearby; the final field
/// Throws InputError as its parts do: layer_frame(), metric_density(), scale_metric().
StagedMetric make_metric(const FeMesh& mesh, FieldHessians fields, const LayerSettings& layers,
                         double vertices, const StageOptions& options,
                         const Contributions& contributions = {});

/// Which stage decided the sizes at a point.
struct StageSizes {
  std::string stage;
  double h1 = 0, h2 = 0;  ///< small and large size
  Vector e1;              ///< direction of h1
  /// The last stage that changed the size by more than a percent. "scaled" never decides: it
  /// changes all sizes of the density by one factor.
  bool decided_h1 = false, decided_h2 = false;
};

/// One entry per stage. At points outside the mesh, the sizes at the nearest point of it.
/// Throws InputError when there are no stages (StageOptions::keep_stages).
std::vector<StageSizes> explain_metric(const Mesh& mesh, const std::vector<MetricStage>& stages,
                                       Point p);

/// The explanation in words, one sentence per size.
std::string describe_stages(const std::vector<StageSizes>& stages);

/// FE.md's rule for the largest stretch of plates: 0.15 L/t within [10, 150].
double plate_stretch_limit(double length, double thickness);

}  // namespace anisofront
