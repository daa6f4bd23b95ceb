#pragma once

#include <optional>

#include "adapt/analyse.hpp"
#include "adapt/loop.hpp"
#include "mesher/geometry/curve.hpp"
#include "mesher/mesh/boundary_domain.hpp"
#include "tests/solver/square_mesh.hpp"

namespace anisofront::acceptance {

/// The square (0, side)^2 with the tags of square_mesh().
inline Domain square_domain(double side) {
  const Point corners[] = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  const char* names[] = {"bottom", "right", "top", "left"};
  Domain domain;
  for (Index k = 0; k < 4; ++k)
    domain.curves.push_back({names[k], k + 1, make_line(corners[k], corners[(k + 1) % 4])});
  add_region(domain, "square", 1, {0, 1, 2, 3}, {});
  return domain;
}

/// Settings of the acceptance table: the program's defaults for problems.
inline AdaptSettings settings_with(double vertices) {
  AdaptSettings settings;
  settings.target.vertices = vertices;
  settings.limits.gradation = 3;
  return settings;
}

/// Five cycles from the initial mesh.
inline LoopInput five_cycles(const Model& model, Domain domain, Mesh initial,
                             const AdaptSettings& settings) {
  LoopInput input;
  attach_to_domain(initial, domain);
  input.initial = std::move(initial);
  input.generate = generate_options(Preset::best);
  input.generate.elements = settings.elements;
  input.analyse = analyse_model(model, domain, settings);
  input.domain = std::move(domain);
  return input;
}

}  // namespace anisofront::acceptance
