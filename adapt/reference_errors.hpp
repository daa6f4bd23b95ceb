#pragma once

#include "adapt/analyse.hpp"
#include "adapt/loop.hpp"

namespace anisofront {

/// How true errors are measured where no exact solution is known: on one mesh more, much finer than
/// that of the last cycle.
struct ReferenceSettings {
  /// Vertices of the mesh; 0: 16 times (first order) or 8 times (second order) those of the last
  /// cycle, with which errors are known to about 3 percent.
  double vertices = 0;
};

/// The mesh is made from the anisotropic energy metric of the last cycle's solution, whatever mode
/// and goal the cycles follow, of triangles; errors are energy_of_difference() relative to the
/// energy norm of its solution. Solves the problem once more on every mesh, in their order.
MeasureErrors errors_against_reference(Model model, Domain domain, AdaptSettings settings,
                                       GenerateOptions generate, ReferenceSettings reference = {},
                                       Monitor monitor = {});

}  // namespace anisofront
