#pragma once

#include "drivers/problem/sample_points.hpp"
#include "drivers/problem/solved.hpp"

namespace anisofront {

/// The solution at a requested place, in the order of Solved::quantities.
struct SampledValue {
  std::string name;
  Point at;
  std::vector<double> state;
};

/// The solution along a line: one row per point with the columns s (length from the start), x, y,
/// Solved::quantities, Solved::line_quantities.
struct SampledLine {
  std::string name;
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

struct Samples {
  std::vector<SampledValue> values;
  std::vector<SampledLine> lines;
};

/// States averaged over the elements that contain each point. `requests`: those of `points`.
Samples sample(const OutputRequests& requests, const SamplePoints& points, const Solved& solved);

/// One line per row below the names of the columns; numbers that read back to the same bits.
std::string line_csv(const SampledLine& line);

}  // namespace anisofront
