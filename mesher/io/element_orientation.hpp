#pragma once

#include <span>

#include "mesher/mesh/mesh.hpp"

namespace anisofront {

// Both turn a clockwise element round (keeping its first vertex) and return nullptr, or what is
// wrong with an element that has no orientation: "has no area" or "crosses itself". Quads are
// judged by the majority of their four corners, so that a merely concave one passes.
const char* make_anticlockwise(Triangle& triangle, std::span<const Point> points);
const char* make_anticlockwise(Quad& quad, std::span<const Point> points);

}  // namespace anisofront
