#pragma once

#include "solver/system/assemble.hpp"

namespace anisofront {

/// Eliminates the unknowns outer, outer + 1, ... of an element, the last first (static
/// condensation): the leading outer x outer block becomes the Schur complement. Throws MeshingError
/// naming the element when a pivot vanishes.
void condense(const Element& element, int outer, ElementSystem& system);

/// The eliminated unknowns of a condensed system, given the outer ones: fills values[outer ...].
void expand(int outer, const ElementSystem& condensed, LocalValues& values);

}  // namespace anisofront
