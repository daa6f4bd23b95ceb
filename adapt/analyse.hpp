#pragma once

#include "adapt/model.hpp"
#include "adapt/steering.hpp"

namespace anisofront {

/// How the error of a solution becomes the metric of the next mesh.
struct AdaptSettings {
  Target target;
  DensityOptions density;
  MetricLimits limits;
  LayerSettings layers;
  /// From cycle 2 on the estimate, not the Hessians, decides how dense the elements are
  /// (equidistribute()).
  bool equidistribute = true;
  bool align = true;
  /// Intersects the a-priori metric of the layers into the metric of the initial mesh.
  bool layer_metric = false;
  Elements elements = Elements::triangle;  ///< of the next mesh, whose vertices are counted
  /// The goal of the model, not the energy error, steers and shapes the metric (MetricNorm::lp with
  /// p = 1, sum of squares; `density` gives mode and floor).
  bool use_goal = false;
  bool keep_stages = false;
};

/// Solve, recover, estimate, metric on a mesh whose curves are those of `domain`.
/// error.estimate is relative to the energy norm of the recovered solution, relative_energy to that
/// of the exact one. Element fields "indicator" and, with a goal, "goal indicator"; vertex fields
/// and values of the model.
/// Throws UsageError unless exactly one target is set; the analysis throws what the model does, and
/// UsageError when a goal is to steer that the model does not have.
Analyse analyse_model(Model model, Domain domain, AdaptSettings settings);

/// The same of a solution on the mesh that is there already.
Analysis analyse_solved(const FeMesh& mesh, SolvedModel solved, const AdaptSettings& settings,
                        int cycle);

/// A prescribed metric, sampled at the vertices; `gradation` > 1 limits how fast the samples may
/// change (limit_gradation), which a metric that jumps or turns within an edge needs. With a model,
/// the problem is solved on each mesh and its error recorded. The analysis throws InputError naming
/// the place where the metric is not finite or not positive definite.
Analyse analyse_prescribed(MetricFunction metric, double gradation = 0, Model model = {},
                           Domain domain = {});

}  // namespace anisofront
