// The mesher alone: a mesh ten times finer across than along the side x = 0.
#include <cstdio>

#include "mesher/generate.hpp"
#include "square.hpp"

using namespace anisofront;

int main() {
  const Metric thin{1 / (0.02 * 0.02), 0, 1 / (0.2 * 0.2)};  // sizes 0.02 and 0.2
  const MetricField field(4, thin);
  const GenerateResult result =
      generate(unit_square(), two_triangles(), field, generate_options(Preset::best));
  std::printf("%zu triangles\n", result.mesh.triangles.size());
  return result.mesh.triangles.empty() ? 1 : 0;
}
