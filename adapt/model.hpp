#pragma once

#include <functional>
#include <optional>

#include "adapt/analysis.hpp"
#include "adapt/goal.hpp"
#include "adapt/point_state.hpp"
#include "solver/scalar/exact_solutions.hpp"

namespace anisofront {

/// A goal with what its estimate needs.
struct SolvedGoal {
  double value = 0;
  FluxSamples dual;
  std::vector<double> dual_curvature_values;  ///< as SolvedModel::curvature_values
  TyingMismatch tying;                        ///< of plates
};

/// A problem solved on one mesh, as estimates, metrics and reports see it.
struct SolvedModel {
  Index dofs = 0;
  int order = 1;  ///< energy error ~ vertices^(-order / 2)
  FluxSamples flux;
  double extra_energy = 0;  ///< int c u_h^2
  /// First-order elements: nodal values whose Hessians shape the metric; empty: those of the
  /// recovered stresses do.
  std::vector<double> curvature_values;
  int curvature_components = 1;
  /// Scaled stresses at a location of this mesh.
  std::function<std::vector<double>(const Location&)> flux_at;
  PointState state;  ///< on this mesh
  /// Energy norms of the error and of the solution, where it is known.
  std::optional<double> true_error, true_energy;
  std::optional<SolvedGoal> goal;
  std::vector<NamedValue> values;
  std::vector<Analysis::Field> vertex_fields;
  std::vector<Profile> profiles;  ///< for the record; the models of this header leave none
  double aside_seconds = 0;       ///< CPU time of true errors and profiles
};

/// Solves a problem on a mesh (which must outlive the result).
using Model = std::function<SolvedModel(const FeMesh& mesh, const Monitor& monitor)>;

/// A place where the solution is watched.
struct NamedPoint {
  std::string name;
  Point at;
};

/// What a model is asked for besides the solution.
struct ModelRequests {
  std::optional<Goal> goal;
  std::vector<NamedPoint> points;  ///< u or w there, in SolvedModel::values
};

/// Fields: "u", "gradient" and with an exact solution "error" = u - u_h. Values: those of the
/// points, "energy" = int a |grad u_h|^2 + c u_h^2. A solution that multigrid found is carried to
/// the next mesh as its initial guess, which changes last digits: a model is for one loop, and a
/// loop that goes on from earlier meshes has to solve on these again.
Model scalar_model(ScalarProblem problem, std::optional<ExactSolution> exact,
                   ScalarOptions options = {}, ModelRequests requests = {});

/// Fields: "deflection", "rotation", "moments" (xx, yy, xy), "shear". Values: those of the points,
/// "energy", "largest deflection", "largest shear" (amounts, at vertices).
Model plate_model(PlateProblem problem, PlateOptions options = {}, ModelRequests requests = {});

}  // namespace anisofront
