#include "drivers/problem/solved.hpp"

#include <spdlog/fmt/fmt.h>

namespace anisofront {

LinearOptions linear_options(const SolverSettings& settings) {
  constexpr double kBytesPerGiB = 1024. * 1024 * 1024;
  LinearOptions options;
  options.method = settings.method;
  options.memory_limit = settings.memory * kBytesPerGiB;
  return options;
}

Json estimate_json(const ErrorEstimate& estimate) {
  return {{"energy", estimate.error}, {"relative_energy", estimate.relative()}};
}

std::string estimate_text(const Json& estimate) {
  return fmt::format("{:.4g} of the energy norm", estimate["relative_energy"].get<double>());
}

FileField vector_field(std::string name, const std::vector<Vector>& vectors) {
  FileField field{std::move(name), 3, {}};
  field.values.reserve(3 * vectors.size());
  for (const Vector v : vectors) field.values.insert(field.values.end(), {v.x, v.y, 0.});
  return field;
}

}  // namespace anisofront
