#include "drivers/solved.hpp"

namespace anisofront {

LinearOptions linear_options(const SolverSettings& settings) {
  constexpr double kBytesPerGiB = 1024. * 1024 * 1024;
  LinearOptions options;
  options.method = settings.method;
  options.memory_limit = settings.memory * kBytesPerGiB;
  return options;
}

FileField vector_field(std::string name, const std::vector<Vector>& vectors) {
  FileField field{std::move(name), 3, {}};
  field.values.reserve(3 * vectors.size());
  for (const Vector v : vectors) field.values.insert(field.values.end(), {v.x, v.y, 0.});
  return field;
}

}  // namespace anisofront
