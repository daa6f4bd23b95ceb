#pragma once

#include "mesher/quads/quad_options.hpp"

namespace anisofront {

/// Pure quadrilaterals that follow the metric of the background, all convex.
/// Throws MeshingError when that is impossible, InputError, BudgetError, Interrupted.
Quadrangulation quadrangulate(const QuadrangulateInput& input, const Monitor& monitor = {});

/// Quad-dominant: triangles merged where that makes a good quadrilateral, smoothed, none divided.
Quadrangulation quad_dominant(const QuadrangulateInput& input, const Monitor& monitor = {});

}  // namespace anisofront
