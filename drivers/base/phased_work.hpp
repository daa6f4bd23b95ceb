#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/base/progress_bar.hpp"
#include "drivers/base/remaining_time.hpp"

namespace anisofront {

/// A phase as the libraries report it, and the shares of all the work at its begin and end.
struct Phase {
  std::string name;
  double begin = 0, end = 1;
};

/// The share of the work that is done in `fraction` of a phase; 0 for phases not in the list.
double share_done(const std::vector<Phase>& phases, std::string_view phase, double fraction);

struct PhasePlan {
  std::vector<Phase> phases;  ///< none: each phase counts for itself
  bool is_timed = false;      ///< the shares are those of the time, which can be foretold
};

/// Work of one piece, from construction on.
class PhasedWork {
 public:
  explicit PhasedWork(std::string label, PhasePlan plan = {});

  /// `now`: seconds since the work began. The fraction never falls when phases are known.
  WorkState report(std::string_view phase, double fraction, double now);

 private:
  std::string label_;
  PhasePlan plan_;
  double done_ = 0;
  RemainingTime time_;
};

}  // namespace anisofront
