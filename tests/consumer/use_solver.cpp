// -Lap u = 1 with u = 0 around the unit square: 0.07367 in the centre.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mesher/generate.hpp"
#include "solver/scalar/solve_scalar.hpp"
#include "square.hpp"

using namespace anisofront;

int main() {
  const MetricField field(4, metric_from_size(0.05));
  const Mesh mesh =
      generate(unit_square(), two_triangles(), field, generate_options(Preset::best)).mesh;
  const FeMesh elements = straight_fe_mesh(mesh);
  ScalarProblem problem;
  problem.source = 1.;
  for (Index side = 1; side <= 4; ++side) problem.dirichlet.push_back({side, 0.});
  ScalarOptions options;
  options.order = 2;
  const ScalarSolution solution = solve_scalar(elements, problem, options);
  const double largest =
      *std::max_element(solution.field.values.begin(), solution.field.values.end());
  std::printf("largest value %.5f\n", largest);
  return std::abs(largest - 0.07367) < 1e-4 ? 0 : 1;
}
