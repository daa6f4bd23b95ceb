#pragma once

#include <filesystem>
#include <functional>
#include <optional>
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

/// What a line is compared with: a table with the column s and some of the quantities, or
/// expressions for some of these.
struct LineReference {
  std::filesystem::path file;  ///< as the study has it, relative to it; empty: expressions
  /// Of x, y, s (length from the start) and the names of the [problem].
  std::vector<NamedExpression> quantities;
  std::string place;
};

/// Where the points of a line stand close together.
enum class LineEnd { start, end, both };

/// Points along a curve of the domain (steps of arc length), or from one point to another.
struct LineRequest {
  std::string name = {};   ///< usable as a file name
  std::string curve = {};  ///< empty: from - to
  Point from = {}, to = {};
  Index points = 101;
  /// The k-th of n steps ends at the share (k / n)^grading of the length; 1: equal steps.
  double grading = 1;
  LineEnd towards = LineEnd::start;  ///< end: mirrored; both: each half of the line by itself
  std::optional<LineReference> reference = {};
  std::string place = {};
};

/// The [output] table.
struct OutputRequests {
  std::vector<std::string> formats{"msh"};  ///< of msh vtu svg mesh
  std::vector<ValueRequest> values;
  std::vector<LineRequest> lines;
};
OutputRequests parse_output(TomlTable table);

/// Replaces the names of reference files in the [output] table of a study, if it has any.
void change_reference_files(toml::table& study,
                            const std::function<std::string(const std::string&)>& change);

/// The file that a name in a study means: paths are relative to the study.
std::filesystem::path beside_study(const std::filesystem::path& study,
                                   const std::filesystem::path& name);

/// The [solver] table.
struct SolverSettings {
  LinearMethod method = LinearMethod::automatic;
  int threads = 0;    ///< 0: all cores
  double memory = 0;  ///< GiB for the factors; 0: what solve_linear() takes itself
  std::string place;  ///< of the method
};
SolverSettings parse_solver(TomlTable table);

}  // namespace anisofront
