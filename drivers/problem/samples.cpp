#include "drivers/problem/samples.hpp"

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"

namespace anisofront {
namespace {

std::vector<double> mean_state(const Places& places, const PointState& state) {
  std::vector<double> mean(state.quantities.at_point.size(), 0);
  for (const Location& place : places) {
    const std::vector<double> own = state.at(place);
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += own[i];
  }
  for (double& value : mean) value /= static_cast<double>(places.size());
  return mean;
}

}  // namespace

NumberTable sample_line(const SampleLine& line, const PointState& state) {
  const Quantities& quantities = state.quantities;
  NumberTable table{{"s", "x", "y"}, {}};
  for (const auto* names : {&quantities.at_point, &quantities.along_line})
    table.columns.insert(table.columns.end(), names->begin(), names->end());
  for (std::size_t i = 0; i < line.places.size(); ++i) {
    const Point at = line.line.points[i];
    const std::vector<double> mean = mean_state(line.places[i], state);
    const std::vector<double> along = quantities.along(mean, line.line.tangents[i]);
    std::vector<double> row{line.line.lengths[i], at.x, at.y};
    row.insert(row.end(), mean.begin(), mean.end());
    row.insert(row.end(), along.begin(), along.end());
    table.rows.push_back(std::move(row));
  }
  return table;
}

Samples sample(const OutputRequests& requests, const SamplePoints& points,
               const PointState& state) {
  Samples samples;
  for (std::size_t i = 0; i < points.values.size(); ++i)
    samples.values.push_back(
        {requests.values[i].name, points.values[i].at, mean_state(points.values[i].places, state)});
  for (const SampleLine& line : points.lines)
    samples.lines.push_back({line.name, sample_line(line, state), {}});
  return samples;
}

std::string table_csv(const NumberTable& table) {
  std::string csv = joined(table.columns, ",") + "\n";
  for (const std::vector<double>& row : table.rows) csv += fmt::format("{}\n", fmt::join(row, ","));
  return csv;
}

}  // namespace anisofront
