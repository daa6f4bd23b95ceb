#include "drivers/base/progress_bar.hpp"

#include <algorithm>
#include <cmath>

#include <spdlog/fmt/fmt.h>

namespace anisofront {
namespace {

constexpr int kLeastColumnsForBar = 50;
/// That of "about 1 min 20 s left": what follows stands still while the seconds run.
constexpr int kTimeWidth = 21;

std::string bar(double fraction, int width, bool has_colour) {
  const int filled = static_cast<int>(std::floor(width * fraction));
  const std::string done = fmt::format("{:=<{}}{}", "", filled, filled < width ? ">" : "");
  return fmt::format("[{}{}{}{:<{}}] ", has_colour ? "\033[32m" : "", done,
                     has_colour ? "\033[0m" : "", "", width - static_cast<int>(done.size()));
}

/// The text cut to the width. Of the parts that two spaces separate the last is left out rather
/// than cut to a few letters.
std::string shortened(std::string text, std::size_t width) {
  constexpr std::size_t kFewLetters = 12;
  if (text.size() > width) {
    text.resize(width);
    const std::size_t part = text.rfind("  ");
    if (part != std::string::npos && width - part < kFewLetters) text.resize(part);
  }
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

double rounded(double seconds, double unit) { return unit * std::round(seconds / unit); }

}  // namespace

std::string time_left_text(double seconds) {
  const double s = std::max(seconds, 0.);
  if (s < 20) return fmt::format("about {:.0f} s left", std::max(1., s));
  if (s < 57.5) return fmt::format("about {:.0f} s left", rounded(s, 5));
  if (s < 595) {
    const int whole = static_cast<int>(rounded(s, 10));
    if (whole % 60 == 0) return fmt::format("about {} min left", whole / 60);
    return fmt::format("about {} min {} s left", whole / 60, whole % 60);
  }
  const double minutes = rounded(s / 60, 1);
  if (minutes < 60) return fmt::format("about {:.0f} min left", minutes);
  if (minutes < 600) {
    const int whole = static_cast<int>(rounded(minutes, 10));
    if (whole % 60 == 0) return fmt::format("about {} h left", whole / 60);
    return fmt::format("about {} h {} min left", whole / 60, whole % 60);
  }
  return fmt::format("about {:.0f} h left", minutes / 60);
}

std::string bar_line(const WorkState& state, int columns, bool has_colour) {
  const double fraction = std::clamp(state.fraction, 0., 1.);
  std::string text = fmt::format("{:3.0f} %  ", std::floor(100 * fraction));
  if (state.seconds_left)
    text += fmt::format("{:<{}}  ", time_left_text(*state.seconds_left), kTimeWidth);
  text += state.label;
  int free = columns - 1;
  std::string line;
  if (columns >= kLeastColumnsForBar) {
    const int width = std::clamp(columns / 6, 10, 30);
    line = bar(fraction, width, has_colour);
    free -= width + 3;
  }
  return line + shortened(text, static_cast<std::size_t>(std::max(free, 0)));
}

}  // namespace anisofront
