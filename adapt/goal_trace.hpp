#pragma once

#include <utility>
#include <vector>

#include "solver/space/coefficient.hpp"

namespace anisofront {

/// Vertices where the curve of a flux goal meets other held ones, with the share of the reaction
/// there that counts to the curve.
using ReactionShares = std::vector<std::pair<Point, double>>;

/// The value that the dual solution of a flux is held at: minus the shares at their vertices,
/// `elsewhere` (-1 on the curve, 0 on others) at all other points.
inline Coefficient dual_trace(const ReactionShares& shares, double elsewhere) {
  if (shares.empty()) return elsewhere;
  return [shares, elsewhere](Point p) {
    for (const auto& [at, share] : shares)
      if (at == p) return -share;
    return elsewhere;
  };
}

}  // namespace anisofront
