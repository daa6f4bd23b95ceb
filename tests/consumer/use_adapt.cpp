// Three cycles of solve, estimate, metric, mesh on a problem with layers along all sides.
#include <cstdio>

#include "adapt/analyse.hpp"
#include "adapt/loop.hpp"
#include "square.hpp"

using namespace anisofront;

int main() {
  ScalarProblem problem;
  problem.diffusion = 1e-3;
  problem.reaction = 1.;
  problem.source = 1.;
  for (Index side = 1; side <= 4; ++side) problem.dirichlet.push_back({side, 0.});

  LoopInput input;
  input.domain = unit_square();
  const MetricField coarse(4, metric_from_size(0.1));
  input.generate = generate_options(Preset::best);
  input.initial = generate(input.domain, two_triangles(), coarse, input.generate).mesh;
  AdaptSettings settings;
  settings.target.vertices = 500;
  input.analyse = analyse_model(scalar_model(problem, {}), input.domain, settings);
  input.cycles = 3;

  const VariantHistory history = adapt_loop(input);
  for (const CycleRecord& cycle : history.cycles)
    std::printf("cycle %d: %d vertices, estimated error %.2e\n", cycle.cycle,
                cycle.background.vertices, cycle.error.estimate.value_or(0));
  const double first = *history.cycles.front().error.estimate;
  return *history.cycles.back().error.estimate < 0.3 * first ? 0 : 1;
}
