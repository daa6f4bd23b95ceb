#pragma once

#include <optional>
#include <string>

namespace anisofront {

/// How far long work is.
struct WorkState {
  double fraction = 0;                 ///< of all that is to be done, 0..1
  std::optional<double> seconds_left;  ///< empty: not known yet
  std::string label;                   ///< what is being done, the most important first
};

/// "about 1 min 20 s left": rounded as estimates deserve, never negative.
std::string time_left_text(double seconds);

/// One line for a terminal with so many columns: the bar, the percentage, the time left and as much
/// of the label as fits. Never as wide as the terminal, which would wrap it; what does not fit is
/// cut from the right, below 50 columns the bar itself is left out.
std::string bar_line(const WorkState& state, int columns, bool has_colour);

}  // namespace anisofront
