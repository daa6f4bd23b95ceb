#pragma once

#include <memory>
#include <mutex>
#include <ostream>
#include <string>
#include <string_view>

#include <spdlog/logger.h>

#include "mesher/geometry/monitor.hpp"

namespace anisofront {

enum class Verbosity { quiet, normal, verbose };

/// Where the program talks: results for people on `out`; warnings, errors and the progress bar on
/// `err`. Colour and progress only on a terminal; NO_COLOR is respected. Thread safe.
class Console {
 public:
  Console(std::ostream& out, std::ostream& err);

  void set_verbosity(Verbosity verbosity);
  bool is_verbose() const { return verbosity_ == Verbosity::verbose; }

  /// A result; not shown when quiet.
  void say(const std::string& text);
  /// A result that was asked for; always shown.
  void print(const std::string& text);
  /// Details, shown when verbose.
  void detail(const std::string& text);
  void warn(const std::string& text);
  void error(const std::string& text);

  /// Draws the bar (at most ten times a second). `fraction`: 0..1.
  void progress(std::string_view label, double fraction);
  void end_progress();

  /// For library calls: warnings go here, progress is drawn as `label: phase`, and the call is
  /// cancelled when the user presses Ctrl-C.
  Monitor monitor(const std::string& label);

 private:
  void erase_bar();

  std::ostream& out_;
  std::shared_ptr<spdlog::logger> log_;
  Verbosity verbosity_ = Verbosity::normal;
  bool draws_bar_ = false;
  bool bar_shown_ = false;
  double last_drawn_ = -1;
  std::mutex mutex_;
};

}  // namespace anisofront
