#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "mesher/geometry/error.hpp"

namespace anisofront {

/// How the libraries talk to the program: they never print and never read global state.
struct Monitor {
  /// Something the user should know although the result is valid.
  std::function<void(const std::string& message)> warn;
  /// Phase and the share of it that is done, 0..1; return false to cancel.
  std::function<bool(std::string_view phase, double fraction)> progress;

  void warning(const std::string& message) const {
    if (warn) warn(message);
  }
  /// Throws Interrupted when the receiver asks to stop.
  void report(std::string_view phase, double fraction) const {
    if (progress && !progress(phase, fraction)) throw Interrupted();
  }
};

}  // namespace anisofront
