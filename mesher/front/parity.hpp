#pragma once

#include <vector>

#include "mesher/geometry/point.hpp"

namespace anisofront {

/// A piece of the boundary between two parts of the domain (kNoIndex: the outside) whose number of
/// edges can be changed by one at some cost (>= 0).
struct ParityLink {
  Index left = kNoIndex, right = kNoIndex;
  double cost = 0;
};

/// Links to be changed, ascending, so that the number of edges of every part listed in `odd`
/// changes its parity and that of no other part does: a T-join over the graph whose nodes are the
/// parts and the outside, which may change at will. One after the other, the odd parts are led
/// along a cheapest chain of links to another odd one or to the outside; a link that two chains
/// share is not changed. Every part must be linked with the outside through others.
/// `parts`: number of parts. O(odd * links log links).
std::vector<Index> cheapest_parity_changes(const std::vector<ParityLink>& links, Index parts,
                                           const std::vector<Index>& odd);

}  // namespace anisofront
