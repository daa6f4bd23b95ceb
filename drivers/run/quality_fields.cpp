#include "drivers/run/quality_fields.hpp"

#include <utility>

#include "mesher/metric/statistics.hpp"

namespace anisofront {

void add_quality_fields(MeshFile& file, const MetricField& metric, int step) {
  const auto add = [&](const char* name, std::vector<double> values) {
    file.element_fields.push_back({name, 1, std::move(values), static_cast<double>(step), step});
  };
  if (!metric.empty()) add("quality", element_qualities(file.mesh, metric));
  add("scaled_jacobian", scaled_jacobians(file.mesh));
}

}  // namespace anisofront
