#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>

#include "adapt/hessian.hpp"
#include "mesher/mesh/mesh.hpp"
#include "mesher/metric/metric_field.hpp"

namespace anisofront {

enum class AdaptMode { anisotropic, isotropic };

/// Bounds of the sizes of the elements, in the length unit of the model.
struct MetricLimits {
  double hmin = 0;
  double hmax = std::numeric_limits<double>::infinity();
  /// Largest ratio of the two sizes at a vertex; the larger size gives way.
  double stretch = std::numeric_limits<double>::infinity();
  /// Largest ratio of sizes over a unit of metric length (see limit_gradation()); <= 1: none.
  double gradation = 0;
};

/// A metric by its eigenvalues (l1 >= l2, in 1/length^2) and the unit eigenvector of l1.
struct PrincipalMetric {
  double l1 = 1, l2 = 1;
  Vector e1{1, 0};
};
using PrincipalField = std::vector<PrincipalMetric>;

Metric metric_of(const PrincipalMetric& m);

/// |H| per vertex: absolute eigenvalues, none below `floor` times the largest of all vertices; the
/// unit metric where all vanish. isotropic: both eigenvalues are the larger one.
PrincipalField absolute_hessians(std::span<const LocalQuadratic> quadratics, AdaptMode mode,
                                 double floor);

/// Shape and relative density of the metric that minimises the L^p interpolation error of linear
/// elements at given complexity: det|H|^(-1/(2p+2)) |H| (A. Loseille, F. Alauzet, Continuous mesh
/// framework part I, SIAM J. Numer. Anal. 49 (2011) 38-60, doi:10.1137/090754078, in 2D).
/// Precondition: p >= 1.
PrincipalField lp_density(PrincipalField absolute_hessians, double p);

/// The metric within hmin, hmax and stretch that is nearest to the given one.
PrincipalMetric limited(PrincipalMetric m, const MetricLimits& limits);

/// Integral of sqrt(det M) over the mesh: the continuous number of elements N.
double complexity(const Mesh& mesh, const MetricField& field);

/// Vertices of a unit mesh of the domain: by Euler's formula half the ideal triangles, half the
/// boundary edges and one (about 1.15 N and half the boundary).
double expected_vertices(const Mesh& mesh, const MetricField& field);

/// What is to be prescribed when a metric is scaled: complexity() or expected_vertices().
using MetricMeasure = std::function<double(const Mesh&, const MetricField&)>;

struct ScaledMetric {
  MetricField field;
  double measure = 0;  ///< what was reached; differs from the target when the limits forbid it
};

/// D * density within all limits, with the one factor D for which the measure of the *limited*
/// field is `target`, to 1e-4 relative (bracketed secant steps on log D). Where the limits make the
/// target unreachable, the nearest measure. Throws InputError when `target` is not positive and
/// finite, or when the limits contradict each other.
ScaledMetric scale_metric(const Mesh& mesh, const PrincipalField& density,
                          const MetricMeasure& measure, double target, const MetricLimits& limits);

}  // namespace anisofront
