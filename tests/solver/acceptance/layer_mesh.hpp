#pragma once

#include <algorithm>

#include "mesher/generate.hpp"
#include "mesher/mesh/boundary_domain.hpp"
#include "tests/solver/acceptance/graded_mesh.hpp"
#include "tests/support/domains.hpp"
#include "tests/support/meshes.hpp"

namespace anisofront::acceptance {

/// Thin along x = 0 and y = 0.
inline Metric layer_metric(const LayerSizes& sizes, Point p) {
  const double hx = sizes.at(p.x), hy = sizes.at(p.y);
  return metric_from_sizes(std::min(hx, sizes.stretch * hy), std::min(hy, sizes.stretch * hx),
                           {1, 0});
}

/// The quarter plate [0, 1/2]^2 meshed by the project's own mesher.
inline Mesh adapted_quarter(const LayerSizes& sizes, Elements elements) {
  const std::vector<double> lines = size_lines(sizes, 0.5);
  Mesh background = triangles_on(lines, lines);
  const Domain domain = testing::square_domain(0.5);
  attach_to_domain(background, domain);
  GenerateOptions options = generate_options(Preset::best);
  options.elements = elements;
  options.quads.effort = QuadEffort::fast;
  return generate(domain, background,
                  testing::sample(background, [&](Point p) { return layer_metric(sizes, p); }),
                  options)
      .mesh;
}

}  // namespace anisofront::acceptance
