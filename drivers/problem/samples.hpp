#pragma once

#include "adapt/point_state.hpp"
#include "adapt/profile.hpp"
#include "drivers/problem/sample_points.hpp"

namespace anisofront {

/// The solution at a requested place, in the order of Quantities::at_point.
struct SampledValue {
  std::string name;
  Point at;
  std::vector<double> state;
};

struct Samples {
  std::vector<SampledValue> values;
  std::vector<Profile> lines;
};

/// States averaged over the elements that contain each point. `requests`: those of `points`.
Samples sample(const OutputRequests& requests, const SamplePoints& points, const PointState& state);

/// Columns s, x, y, Quantities::at_point, Quantities::along_line.
NumberTable sample_line(const SampleLine& line, const PointState& state);

/// One line per row below the names of the columns; numbers that read back to the same bits.
std::string table_csv(const NumberTable& table);

}  // namespace anisofront
