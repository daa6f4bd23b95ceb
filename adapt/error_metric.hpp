#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>

#include "adapt/hessian.hpp"
#include "mesher/mesh/mesh.hpp"
#include "mesher/metric/metric_field.hpp"
#include "mesher/quads/quad_options.hpp"

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

/// The eigenvalues and the first eigenvector of a metric.
PrincipalMetric principal_of(const Metric& m);

/// Raises the eigenvalues to at least `floor` times the largest of all vertices; the unit metric
/// where all vanish. isotropic: both eigenvalues become the larger one.
void lift_to_floor(PrincipalField& field, AdaptMode mode, double floor);

/// |H| per vertex: absolute eigenvalues, none below `floor` times the largest of all vertices; the
/// unit metric where all vanish. isotropic: both eigenvalues are the larger one.
PrincipalField absolute_hessians(std::span<const LocalQuadratic> quadratics, AdaptMode mode,
                                 double floor);

/// Shape and relative density of the metric that minimises the L^p interpolation error of linear
/// elements at given complexity: det|H|^(-1/(2p+2)) |H| (A. Loseille, F. Alauzet, Continuous mesh
/// framework part I, SIAM J. Numer. Anal. 49 (2011) 38-60, doi:10.1137/090754078, in 2D).
/// Precondition: p >= 1.
PrincipalField lp_density(PrincipalField absolute_hessians, double p);

/// The same for the H1 seminorm of the error of linear elements with right-angled elements along
/// the eigenvectors: det|H|^(-1/2) H^2, which minimises the integral of l1^2 h1^2 + l2^2 h2^2 over
/// the eigenvalues of |H|. The stretch is l1/l2, not its root: limit it.
PrincipalField energy_density(PrincipalField absolute_hessians);

/// The metric within hmin, hmax and stretch that is nearest to the given one.
PrincipalMetric limited(PrincipalMetric m, const MetricLimits& limits);

/// Integral of sqrt(det M) over the mesh: the continuous number of elements N.
double complexity(const Mesh& mesh, const MetricField& field);

/// Vertices of a unit mesh of triangles on the domain: by Euler's formula half the ideal triangles,
/// half the boundary edges and one (about 1.15 N and half the boundary).
double expected_vertices(const Mesh& mesh, const MetricField& field);

/// What is to be prescribed when a metric is scaled: complexity() or expected_vertices().
using MetricMeasure = std::function<double(const Mesh&, const MetricField&)>;

/// Vertices of a unit mesh of these elements on the domain of this mesh, whose boundary is looked
/// up once (a third of the time). Mixed meshes count as quadrilaterals.
MetricMeasure vertex_measure(const Mesh& mesh, Elements elements = Elements::triangle);

/// factor * density, intersected with `beside` (one metric per vertex, or none), then limited().
/// No gradation.
MetricField bounded_metric(const PrincipalField& density, double factor, const MetricLimits& limits,
                           std::span<const Metric> beside = {});

struct ScaledMetric {
  MetricField field;
  double measure = 0;  ///< what was reached; differs from the target when the limits forbid it
  double factor = 1;   ///< of the density
};

/// bounded_metric(), graded, with the one factor for which the measure of the result is `target`,
/// to 1e-4 relative, with gradation to 5e-4 (bracketed secant steps on the logarithm of the factor,
/// first without gradation, which costs far more than the rest; two or three fields are graded).
/// `beside` keeps its sizes whatever the factor. Where it or the limits make the target
/// unreachable, the nearest measure.
/// Throws InputError when `target` is not positive and finite, when the limits contradict each
/// other, or when the density or `beside` do not hold one (finite) metric per vertex.
ScaledMetric scale_metric(const Mesh& mesh, const PrincipalField& density,
                          const MetricMeasure& measure, double target, const MetricLimits& limits,
                          std::span<const Metric> beside = {});

}  // namespace anisofront
