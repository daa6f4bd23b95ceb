#pragma once

#include <optional>

#include "adapt/error_metric.hpp"
#include "adapt/loop.hpp"
#include "solver/scalar/exact_solutions.hpp"
#include "solver/scalar/scalar_problem.hpp"

namespace anisofront {

/// How the error of a solution becomes the metric of the next mesh. Exactly one target is set.
struct AdaptSettings {
  AdaptMode mode = AdaptMode::anisotropic;
  /// Vertices of the next mesh.
  std::optional<double> target_vertices;
  /// Relative energy error to reach. The true error steers where an exact solution is known, the
  /// estimate elsewhere (believed from cycle 2 on); the vertices follow from the order of linear
  /// elements, error ~ V^(-1/2), and at most double in a cycle.
  std::optional<double> target_error;
  MetricLimits limits;
  /// The metric minimises the L^p norm of the interpolation error.
  double p = 2;
  /// Smallest curvature, as a share of the largest.
  double curvature_floor = 1e-6;
};

/// Solve, estimate, Hessian, metric on a mesh. The analysis has the field "u" and, with an exact
/// solution, "error" = u - u_h; error.estimate is relative to the energy norm of the recovered
/// solution, error.relative_energy to that of the exact one (closed form where there is one).
/// Throws UsageError unless exactly one target is set; the analysis throws what solve_scalar()
/// does.
Analyse analyse_scalar(ScalarProblem problem, std::optional<ExactSolution> exact,
                       AdaptSettings settings);

/// A prescribed metric, sampled at the vertices; `gradation` > 1 limits how fast the samples may
/// change (limit_gradation), which a metric that jumps or turns within an edge needs. The analysis
/// throws InputError naming the place where the metric is not finite or not positive definite.
Analyse analyse_prescribed(MetricFunction metric, double gradation = 0);

}  // namespace anisofront
