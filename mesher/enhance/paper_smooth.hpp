#pragma once

#include "mesher/enhance/patch.hpp"

namespace anisofront {

/// One cycle of edge length smoothing to the letter (Eqn 25a with ERRATA): every interior vertex
/// goes to the centroid of the places at unit distance (Appendix B lengths) from its neighbours, if
/// the product of the alpha~ around it grows.
void paper_length_smoothing(Patch& patch);

/// One cycle of element quality smoothing to the letter (Eqn 26).
void paper_quality_smoothing(Patch& patch);

}  // namespace anisofront
