#pragma once

#include <span>

#include "adapt/error_metric.hpp"

namespace anisofront {

/// Which error the metric makes small.
enum class MetricNorm {
  lp,     ///< L^p of linear interpolation: det|H|^(-1/(2p+2)) |H|
  energy  ///< H1 seminorm of linear elements: det|H|^(-1/2) H^2 (needs right-angled elements)
};

/// How several fields share one metric.
enum class Combination {
  sum_of_squares,  ///< |H| = (sum_c H_c^2)^(1/2): default
  intersection     ///< of the metrics of the fields, each at equal complexity (the paper, Eqn 8)
};

struct DensityOptions {
  AdaptMode mode = AdaptMode::anisotropic;
  MetricNorm norm = MetricNorm::lp;
  double p = 2;
  Combination combination = Combination::sum_of_squares;
  /// Smallest curvature as a share of the largest. Layers have 1 / width^2 times the curvature of
  /// smooth parts: 1e6 in a plate with t = .001.
  double curvature_floor = 1e-8;
};

/// Hessians of several fields: fields[c][v] at vertex v. A first-order solution gives its own
/// Hessian (one field); a second-order one those of its recovered, energy-scaled stresses, to which
/// the linear-interpolation formula applies (FE.md 4).
using FieldHessians = std::vector<std::vector<Hessian>>;

/// Shape and relative density, to be scaled by scale_metric(). isotropic: the larger eigenvalue of
/// |H| in both directions.
/// Several fields. sum_of_squares: |H| is the symmetric root of sum_c H_c^2, the fields as they are
/// (they must share a unit, like energy-scaled stresses). intersection: each field alone gives its
/// metric, all are scaled to one complexity and intersected in the order of the fields; another
/// order may differ by some percent, because Eqn 8 is not associative. A field whose
/// curvatures stay below 1e-12 of the largest of all fields is noise and not intersected.
/// Laws: a factor on all Hessians changes the shape nowhere; a rotation of mesh and fields rotates
/// the metric; one field gives the same either way; sum_of_squares does not depend on the order.
/// Throws InputError when there is no field, when one does not hold a finite Hessian per vertex
/// (naming field and place), or when p or the floor are out of range (p >= 1, 0 < floor < 1).
PrincipalField metric_density(const Mesh& mesh, const FieldHessians& fields,
                              const DensityOptions& options);

/// The symmetric root of sum_c H_c^2 at vertex v: |H| of one field. Precondition: the fields hold a
/// finite Hessian there.
Hessian root_of_squares(const FieldHessians& fields, std::size_t v);

/// Hessians of nodal values, `components` per vertex: fit_quadratics(). By default values are
/// continuous over the interfaces of regions and their slopes are not.
FieldHessians hessians_of(const Mesh& mesh, std::span<const double> values, int components,
                          AcrossInterfaces across = AcrossInterfaces::kink);

}  // namespace anisofront
