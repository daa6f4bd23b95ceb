#include "tests/bench/quad_quality.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {

QuadQuality quad_quality(const Mesh& mesh, const MetricFunction& metric) {
  constexpr double kBad = 0.2;
  QuadQuality quality;
  quality.all = mesh_statistics(mesh, metric);
  MetricField field;
  field.reserve(mesh.points.size());
  for (const Point p : mesh.points) field.push_back(metric(p));
  const std::vector<double> qualities = element_qualities(mesh, field);
  double log_sum = 0;
  Index convex = 0;
  for (std::size_t q = mesh.triangles.size(); q < qualities.size(); ++q) {
    const double beta = qualities[q];
    quality.beta_min = std::min(quality.beta_min, beta);
    quality.bad += beta < kBad;
    if (beta <= 0) continue;
    log_sum += std::log(beta);
    ++convex;
  }
  if (convex > 0) quality.beta_mean = std::exp(log_sum / convex);
  return quality;
}

}  // namespace anisofront
