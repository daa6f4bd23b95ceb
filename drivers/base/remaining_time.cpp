#include "drivers/base/remaining_time.hpp"

#include <algorithm>
#include <cmath>

namespace anisofront {

void RemainingTime::update(double now, double fraction) {
  if (fraction <= 0) return;
  // Work goes on as fast as so far. The estimated end is smoothed over a tenth of the time gone by:
  // little at first, when each cycle teaches much.
  const double end = now / std::min(fraction, 1.);
  const double memory = 0.1 * now + 0.1;
  const double weight = end_ ? 1 - std::exp(-(now - updated_) / memory) : 1;
  end_ = end_.value_or(0) + weight * (end - end_.value_or(0));
  updated_ = now;
}

std::optional<double> RemainingTime::seconds_left(double now) const {
  if (!end_) return {};
  return std::max(0., *end_ - now);
}

}  // namespace anisofront
