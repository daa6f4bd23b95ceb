#pragma once

#include <vector>

#include "adapt/density.hpp"
#include "adapt/recovery.hpp"

namespace anisofront {

/// A quantity of interest J(u), linear in the solution: what the error is to be small in instead of
/// the energy norm.
struct Goal {
  enum class Kind {
    /// Mean of u (w of plates) round a point with the weight (1 - (r / radius)^2)^2, divided by the
    /// integral of the weight over the part of the disc inside the domain. A point value is not
    /// bounded in the energy norm, this is.
    patch_mean,
    region_mean,  ///< mean of u (w) over the elements with region tag `tag`
    /// Scalar: int a du/dn over the edges with `tag`; plate: int Q_n, the force of the support.
    /// u (w) is held on these edges.
    curve_flux
  };
  Kind kind = Kind::patch_mean;
  Point at;
  double radius = 0;  ///< length
  Index tag = 0;
};

/// The problem whose solution z weighs the residual: a(v, z) = J(v) for all v that vanish where u
/// (w) is held. Conditions are those of the problem with data 0, fluxes without transfer and loads
/// are left out. Patch and region means become the source, which the solver's quadrature
/// integrates as exactly as goal_value() does, however small the disc (mean_source()). A flux has
/// no source but z = -1 on its curve: then
/// J(u) - J(u_h) = a(u - u_h, z - z_h) as for the means. At a vertex where the curve meets other
/// held ones z is minus the share of the reaction there that goal_value() counts to the curve.
/// Throws InputError: convection (the estimate is for symmetric problems), a radius that is not
/// positive, a disc that no element meets, tags that no element or edge carries, a flux through a
/// curve where the value is not prescribed.
ScalarProblem dual_problem(const FeMesh& mesh, const ScalarProblem& problem, const Goal& goal);
PlateProblem dual_problem(const FeMesh& mesh, const PlateProblem& problem, const Goal& goal);

/// J(u_h); fluxes by total_flux() and by the reactions of the supports, which converge twice as
/// fast as those of the gradients. Throws InputError as dual_problem() does, convection is allowed.
double goal_value(const FeMesh& mesh, const ScalarProblem& problem, const ScalarSolution& solution,
                  const Goal& goal);
double goal_value(const FeMesh& mesh, const PlateProblem& problem, const PlateSolution& solution,
                  const Goal& goal);

/// J(u) - J(u_h) = a(u - u_h, z - z_h), with the recovered stresses in place of the exact ones
/// (R. Becker, R. Rannacher, Acta Numerica 10 (2001) 1-102, doi:10.1017/S0962492901000010).
/// Left out: the parts of reaction and transfer, which are of higher order; the errors of
/// prescribed values that the elements do not take exactly; for a flux, where the curve meets
/// another held one, the error of the stresses that divide the reaction there.
/// Measured, estimate over true error on uniform and perturbed meshes of all elements: order 1,
/// means and fluxes 0.95 to 1.05, patches inside one element 0.4 to 2; order 2, 0.6 to 1.3 once a
/// patch is some elements wide; plates (mitc, with tying) 0.9 to 1.25, thin ones whose layers are
/// just resolved 0.6 to 2. Through curves between other held ones: near 1 on regular meshes,
/// elsewhere the order of magnitude only and not always the sign, as with arnold_falk.
struct GoalEstimate {
  double error = 0;                ///< signed
  std::vector<double> indicators;  ///< per element, the amount of its part of `error`
  /// |f* - f_h| of the solution and of the dual, L2 means over the elements around each vertex.
  std::vector<double> primal_weights, dual_weights;
};

/// Plates: sqrt(k G t) (gamma - R gamma) at the samples of a solution, 2 each; R gamma are the tied
/// shear strains, which the shear forces belong to. To be taken of the solution and of the dual.
/// Empty where it would not help: for arnold_falk, whose deflections jump besides, and for the
/// force on a curve that meets other supports (the dual deflection jumps there, and its shear
/// forces are too rough for recovery). In plate_goal.cpp.
std::vector<double> tying_mismatch(const FeMesh& mesh, const PlateProblem& problem,
                                   const PlateSolution& solution, const FluxSamples& samples,
                                   const Goal& goal);
struct TyingMismatch {
  std::vector<double> primal, dual;
};

/// With the mismatch of the tied shear strains (both parts or none) the estimate counts
/// - int Q . (gamma - R gamma)(z_h) - int Q_z . (gamma - R gamma)(u_h), which is of the order of
/// the rest, as tied elements do not conform.
/// Precondition: both samples were taken on the mesh at the same points.
GoalEstimate estimate_goal(const FeMesh& mesh, const FluxSamples& primal,
                           const RecoveredFlux& primal_recovered, const FluxSamples& dual,
                           const RecoveredFlux& dual_recovered, const TyingMismatch& tying = {});

/// w_z |H_u| + w_u |H_z| at each vertex, |H| the symmetric root of the sum of squares over the
/// fields, weights lifted to 1e-3 of their largest: to be used with MetricNorm::lp and p = 1 (FE.md
/// 4). Throws InputError when the fields do not hold one finite Hessian per vertex.
std::vector<Hessian> goal_hessians(const FieldHessians& primal, const FieldHessians& dual,
                                   const GoalEstimate& estimate);

}  // namespace anisofront
