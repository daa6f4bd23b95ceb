#pragma once

#include "drivers/problem/samples.hpp"
#include "drivers/problem/solved.hpp"
#include "drivers/study/study_file.hpp"

namespace anisofront {

/// Wall-clock seconds of one solve.
struct SolveSeconds {
  double mesh = 0;    ///< initial mesh, curved edges, elements of the requested points
  double fields = 0;  ///< all after the solution of the system: states, errors, reactions
  double total = 0;
};

/// Everything about one solve.
struct SolutionRecord {
  const Variant& variant;
  const FeMesh& mesh;
  Solved solved;
  Samples samples;
  std::vector<std::string> warnings;
  SolveSeconds seconds;
};

/// solution.json, schema 1 (README, "Solve one problem").
Json solution_json(const SolutionRecord& record);

/// What the console shows of it.
std::string solution_summary(const SolutionRecord& record);

}  // namespace anisofront
