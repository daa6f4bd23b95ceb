#pragma once

#include <vector>

#include "adapt/recovery.hpp"

namespace anisofront {

/// Error estimate in the energy norm.
struct ErrorEstimate {
  double error = 0;                ///< sqrt(int |f* - f_h|^2)
  double energy = 0;               ///< sqrt(int |f*|^2 + c u_h^2)
  std::vector<double> indicators;  ///< per element: its part of `error` (squares add up)
  double relative() const { return error / energy; }
};

/// Recovered less computed stresses, over the samples. `extra_energy`: int c u_h^2 of a scalar
/// problem with reaction (0 else); the reaction part of the error is of higher order and left out.
ErrorEstimate estimate_by_recovery(const FeMesh& mesh, const FluxSamples& samples,
                                   const RecoveredFlux& recovered, double extra_energy);

/// The same with samples and recovery of its own.
ErrorEstimate estimate_by_recovery(const FeMesh& mesh, const ScalarProblem& problem,
                                   const ScalarField& field);
ErrorEstimate estimate_by_recovery(const FeMesh& mesh, const PlateProblem& problem,
                                   const PlateSolution& solution);

/// int c u_h^2.
double reaction_energy(const FeMesh& mesh, const ScalarProblem& problem, const ScalarField& field);

/// Residual estimate of scalar problems: per element h_T |f - c u + div a grad u - b . grad u| and
/// the jumps of a du/dn over its edges, with lengths and scalings that are robust for stretched
/// elements and for reaction (see the .cpp for the references). An upper bound up to a constant:
/// 3 to 7 times the error on the tested meshes. In residual_estimate.cpp.
ErrorEstimate estimate_by_residual(const FeMesh& mesh, const ScalarProblem& problem,
                                   const ScalarField& field);

}  // namespace anisofront
