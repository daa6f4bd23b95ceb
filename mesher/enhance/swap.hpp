#pragma once

#include "mesher/enhance/patch.hpp"

namespace anisofront {

/// When a diagonal is swapped (Fig. 6; ERRATA: alpha, not beta).
enum class SwapCriterion {
  product,  ///< the product of the two alphas grows (the paper)
  minimum,  ///< the smaller alpha grows
};

/// Swaps the edge opposite vertex k of the triangle if the criterion says so and the result is
/// valid by exact predicates. Returns whether it did.
bool try_swap(Patch& patch, Index triangle, int k, SwapCriterion criterion);

/// Swaps the edge opposite vertex k whatever the qualities, if the result is valid.
bool force_swap(Patch& patch, Index triangle, int k);

/// Swaps until nothing changes: one sweep, each success followed up around the place. Only pairs in
/// which one alpha is at most `threshold` are looked at.
void swap_all(Patch& patch, SwapCriterion criterion, double threshold);

}  // namespace anisofront
