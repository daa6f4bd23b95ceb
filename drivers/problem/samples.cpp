#include "drivers/problem/samples.hpp"

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"

namespace anisofront {
namespace {

std::vector<double> mean_state(const SamplePoint& point, const Solved& solved) {
  std::vector<double> mean(solved.quantities.size(), 0);
  for (const Location& place : point.places) {
    const std::vector<double> state = solved.state(place);
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += state[i];
  }
  for (double& value : mean) value /= static_cast<double>(point.places.size());
  return mean;
}

SampledLine sample_line(const SampleLine& line, const Solved& solved) {
  SampledLine sampled{line.name, {"s", "x", "y"}, {}};
  for (const auto* names : {&solved.quantities, &solved.line_quantities})
    sampled.columns.insert(sampled.columns.end(), names->begin(), names->end());
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const std::vector<double> state = mean_state(line.points[i], solved);
    const std::vector<double> along = solved.along(state, line.tangents[i]);
    std::vector<double> row{line.lengths[i], line.points[i].at.x, line.points[i].at.y};
    row.insert(row.end(), state.begin(), state.end());
    row.insert(row.end(), along.begin(), along.end());
    sampled.rows.push_back(std::move(row));
  }
  return sampled;
}

}  // namespace

Samples sample(const OutputRequests& requests, const SamplePoints& points, const Solved& solved) {
  Samples samples;
  for (std::size_t i = 0; i < points.values.size(); ++i)
    samples.values.push_back(
        {requests.values[i].name, points.values[i].at, mean_state(points.values[i], solved)});
  for (const SampleLine& line : points.lines) samples.lines.push_back(sample_line(line, solved));
  return samples;
}

std::string line_csv(const SampledLine& line) {
  std::string csv = joined(line.columns, ",") + "\n";
  for (const std::vector<double>& row : line.rows) csv += fmt::format("{}\n", fmt::join(row, ","));
  return csv;
}

}  // namespace anisofront
