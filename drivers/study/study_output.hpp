#pragma once

#include <string>
#include <vector>

#include "drivers/study/toml_table.hpp"
#include "solver/system/linear_solve.hpp"

namespace anisofront {

/// A place where the solution is asked for.
struct ValueRequest {
  std::string name;
  Point at;
  std::string place;
};

/// Points along a curve of the domain (equal steps of arc length), or from one point to another.
struct LineRequest {
  std::string name;   ///< usable as a file name
  std::string curve;  ///< empty: from - to
  Point from, to;
  Index points = 101;
  std::string place;
};

/// The [output] table.
struct OutputRequests {
  std::vector<std::string> formats{"msh"};  ///< of msh vtu svg mesh
  std::vector<ValueRequest> values;
  std::vector<LineRequest> lines;
};
OutputRequests parse_output(TomlTable table);

/// The [solver] table.
struct SolverSettings {
  LinearMethod method = LinearMethod::automatic;
  int threads = 0;    ///< 0: all cores
  double memory = 0;  ///< GiB for the factors; 0: what solve_linear() takes itself
  std::string place;  ///< of the method
};
SolverSettings parse_solver(TomlTable table);

}  // namespace anisofront
