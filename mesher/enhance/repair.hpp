#pragma once

#include "mesher/enhance/patch.hpp"

namespace anisofront {

/// Around every triangle with alpha below `bad_alpha` or an edge outside [1/bad_length,
/// bad_length]: tries each swap, collapse and split of its edges, smooths the neighbourhood, and
/// keeps the best outcome if it lowers the energy there; otherwise all is put back. Operations that
/// look useless by themselves can pay after smoothing. Returns the number of changes kept.
int repair_worst(Patch& patch, double bad_alpha, double bad_length);

}  // namespace anisofront
