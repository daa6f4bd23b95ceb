#include "drivers/base/phased_work.hpp"

#include <algorithm>
#include <utility>

namespace anisofront {

double share_done(const std::vector<Phase>& phases, std::string_view phase, double fraction) {
  for (const Phase& known : phases)
    if (known.name == phase) return known.begin + fraction * (known.end - known.begin);
  return 0;
}

PhasedWork::PhasedWork(std::string label, PhasePlan plan)
    : label_(std::move(label)), plan_(std::move(plan)) {}

WorkState PhasedWork::report(std::string_view phase, double fraction, double now) {
  const std::string label = label_ + ": " + std::string(phase);
  if (plan_.phases.empty()) return {fraction, {}, label};
  done_ = std::max(done_, share_done(plan_.phases, phase, fraction));
  if (!plan_.is_timed) return {done_, {}, label};
  time_.update(now, done_);
  return {done_, time_.seconds_left(now), label};
}

}  // namespace anisofront
