#pragma once

#include <mutex>
#include <ostream>
#include <string>

#include "drivers/base/json.hpp"
#include "drivers/base/phased_work.hpp"
#include "drivers/base/terminal.hpp"
#include "mesher/geometry/monitor.hpp"

namespace anisofront {

enum class Verbosity { quiet, normal, verbose };
enum class LogFormat { text, json };

/// Where the program talks: results for people on `out`; warnings, errors, events and the progress
/// bar on `err`. The bar and colours appear only where terminal_of() welcomes them. Thread safe.
class Console {
 public:
  Console(std::ostream& out, std::ostream& err);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  void set_verbosity(Verbosity verbosity);
  /// json: every line on `err` is one JSON object (json_log_line()), and there is no bar.
  void set_log_format(LogFormat format);
  bool is_verbose() const { return verbosity_ == Verbosity::verbose; }

  /// A result; not shown when quiet.
  void say(const std::string& text);
  /// Text that was asked for, just as it is; always shown.
  void write(const std::string& text);
  /// The same as a line.
  void print(const std::string& text);
  /// Details, shown when verbose.
  void detail(const std::string& text);
  /// Not shown when quiet.
  void warn(const std::string& text);
  void error(const std::string& text);
  /// Something that programs wait for, in a JSON log only: {"event": name} and the fields.
  void event(const std::string& name, const std::string& message, const Json& fields);

  /// Draws the bar, at most ten times a second.
  void progress(const WorkState& state);
  void end_progress();

  /// For library calls: warnings go here, progress is drawn as `label: phase` (see PhasedWork), and
  /// the call is cancelled when the user presses Ctrl-C.
  Monitor monitor(const std::string& label, const PhasePlan& plan = {});

 private:
  void log(const std::string& level, const std::string& colour, const std::string& text);
  void erase_bar();

  std::ostream& out_;
  std::ostream& err_;
  Terminal terminal_;
  Verbosity verbosity_ = Verbosity::normal;
  LogFormat format_ = LogFormat::text;
  bool bar_shown_ = false;
  double last_drawn_;
  std::mutex mutex_;
};

}  // namespace anisofront
