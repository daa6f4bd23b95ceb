#pragma once

#include <string>
#include <utility>
#include <vector>

#include "adapt/energy_estimate.hpp"
#include "adapt/point_state.hpp"
#include "drivers/base/json.hpp"
#include "drivers/study/study.hpp"
#include "mesher/io/gmsh.hpp"
#include "solver/system/linear_solve.hpp"

namespace anisofront {

/// What one solve leaves, in the same shape for all kinds of problems.
struct Solved {
  PointState state;
  std::vector<FileField> vertex_fields;
  Json totals;    ///< entries of solution.json: energy, reactions, errors
  Json settings;  ///< those of the problem that decide how to read the numbers
  std::vector<std::pair<std::string, std::string>> summary;  ///< of the totals, for people
  LinearReport linear;
  double assembly_seconds = 0;
};

/// Solve the problem of the study on a mesh. The mesh must outlive the result. Throw what
/// solve_scalar(), solve_plate() and the set-up of the problem throw.
Solved solve_scalar_study(const Study& study, const Domain& domain, const FeMesh& mesh,
                          const Monitor& monitor = {});
Solved solve_plate_study(const Study& study, const Domain& domain, const FeMesh& mesh,
                         const Monitor& monitor = {});

/// The [solver] table as options.
LinearOptions linear_options(const SolverSettings& settings);

/// Error of the solution as recovered stresses see it: for solution.json, and of it for people.
Json estimate_json(const ErrorEstimate& estimate);
std::string estimate_text(const Json& estimate);

/// A field of vectors as mesh files have it: three components, the last 0.
FileField vector_field(std::string name, const std::vector<Vector>& vectors);

}  // namespace anisofront
