#pragma once

#include "mesher/enhance/patch.hpp"

namespace anisofront {

/// Moves vertex a onto its neighbour b and removes the two triangles between them, unless a is
/// fixed, the result is invalid (exact), an edge would become longer than `longest` or a triangle
/// worse than both `least_alpha` and the worst before. Returns whether it did.
bool collapse(Patch& patch, Index a, Index b, double longest, double least_alpha);

}  // namespace anisofront
