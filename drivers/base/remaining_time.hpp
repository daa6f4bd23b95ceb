#pragma once

#include <optional>

namespace anisofront {

/// Estimates when work will be finished from the share of it that is done. Time is in seconds since
/// the work began.
class RemainingTime {
 public:
  /// At `now` the share `fraction` was done. Both grow from call to call.
  void update(double now, double fraction);

  /// Empty until some work is done; never negative. Counts down between updates.
  std::optional<double> seconds_left(double now) const;

 private:
  std::optional<double> end_;
  double updated_ = 0;
};

}  // namespace anisofront
